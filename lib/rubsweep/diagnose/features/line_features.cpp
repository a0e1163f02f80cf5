#include "rubsweep/diagnose/features/line_features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace rubsweep::diagnose::features {
namespace {

using Complex = std::complex<double>;

constexpr double smallest_energy = 1e-7;  ///< share below which energy counts as none
constexpr int most_fraction = 5;          ///< 1/2 to 1/5

/// Energy of every line as a Hann window sees it, as a share of all.
class HannEnergy {
 public:
  HannEnergy(const MotionLines& lines, bool plane)
      : turns_(lines.turns), last_(lines.last()), first_(plane ? -last_ : 1) {
    const double all = size_of(lines) * size_of(lines) * (plane ? 1 : 0.5);
    share_.assign(static_cast<std::size_t>(2 * last_ + 1), 0);
    for (int k = first_; k <= last_; ++k) {
      if (k == 0) continue;
      const auto line = [&](int j) { return j == 0 || std::abs(j) > last_ ? Complex(0) : lines.at(j); };
      // The window keeps 3/8 of the energy of a line amidst a bin.
      share_[index(k)] = std::norm(line(k) / 2.0 - (line(k - 1) + line(k + 1)) / 4.0) * 8 / 3 / all;
    }
  }

  int first() const { return first_; }
  int last() const { return last_; }
  int turns() const { return turns_; }
  double operator[](int k) const { return k < first_ || k > last_ ? 0 : share_[index(k)]; }

  double near(double order, int bins) const {
    const int middle = static_cast<int>(std::lround(order * turns_));
    double sum = 0;
    for (int k = middle - bins; k <= middle + bins; ++k) sum += (*this)[k];
    return sum;
  }

 private:
  std::size_t index(int k) const { return static_cast<std::size_t>(k + last_); }
  int turns_, last_, first_;
  std::vector<double> share_;
};

double logarithm(double share) { return std::log10(std::max(share, smallest_energy)); }

/// Whether a line is apart from all multiples of the shaft speed, 0X included.
bool between_multiples(const HannEnergy& energy, int k, int bins) {
  const double order = static_cast<double>(k) / energy.turns();
  return std::abs(k - std::lround(order) * energy.turns()) > bins;
}

void add_multiples(const HannEnergy& energy, bool plane, Features& features) {
  for (int order = plane ? -4 : 1; order <= 5; ++order)
    if (order != 0) add(features, fmt::format("energy at {}X", order), logarithm(energy.near(order, 2)));
}

void add_fractions(const HannEnergy& energy, Features& features) {
  const double most_order = static_cast<double>(energy.last()) / energy.turns();
  for (int n = 2; n <= most_fraction; ++n) {
    double sum = 0;
    const int most = static_cast<int>(most_order * n);
    for (int j = energy.first() < 0 ? -most : 1; j <= most; ++j)
      if (j % n != 0) sum += energy.near(static_cast<double>(j) / n, 1);
    add(features, fmt::format("energy at multiples of 1/{}X", n), logarithm(sum));
  }
}

/// Energy between the multiples of the shaft speed by where it is.
void add_rest(const HannEnergy& energy, Features& features) {
  double forward = 0, backward = 0, slow = 0;
  for (int k = energy.first(); k <= energy.last(); ++k) {
    if (!between_multiples(energy, k, 2)) continue;
    (k > 0 ? forward : backward) += energy[k];
    if (std::abs(k) < energy.turns()) slow += energy[k];
  }
  add(features, "energy between multiples", logarithm(forward + backward));
  if (energy.first() < 0) add(features, "backward energy between multiples", logarithm(backward));
  add(features, "energy below 1X", logarithm(slow));
}

/// Order of the line by the parabola through the logarithms of its energy and those beside it.
double order_of_line(const HannEnergy& energy, int k) {
  const auto height = [&](int j) { return std::log(std::max(energy[j], 1e-300)); };
  const double left = height(k - 1), middle = height(k), right = height(k + 1),
               bend = left - 2 * middle + right;
  const double shift = bend < 0 ? std::clamp((left - right) / (2 * bend), -0.5, 0.5) : 0;
  return (k + shift) / energy.turns();
}

/// The two strongest lines between the multiples.
void add_strongest(const HannEnergy& energy, Features& features) {
  std::vector<int> found;
  for (int rank = 1; rank <= 2; ++rank) {
    int best = 0;
    for (int k = energy.first(); k <= energy.last(); ++k) {
      const bool taken = std::ranges::any_of(found, [&](int other) { return std::abs(k - other) <= 2; });
      if (between_multiples(energy, k, 2) && !taken && energy[k] > energy[best]) best = k;
    }
    const double share = best == 0 ? 0 : energy[best - 1] + energy[best] + energy[best + 1];
    add(features, fmt::format("order of line {} between multiples", rank),
        share > 10 * smallest_energy ? order_of_line(energy, best) : 0);
    add(features, fmt::format("energy of line {} between multiples", rank), logarithm(share));
    found.push_back(best);
  }
}

/// Distance of an order to the next whole one.
double off_whole(double order) { return std::abs(order - std::round(order)); }

/// The strongest line between the multiples: the energy there that lies on none of its sidebands, at its
/// order and whole ones, and its width. Both are small for a fraction or a torus, large for chaos and for
/// several causes.
void add_sidebands(const HannEnergy& energy, Features& features) {
  int best = 0;
  for (int k = energy.first(); k <= energy.last(); ++k)
    if (between_multiples(energy, k, 2) && energy[k] > energy[best]) best = k;
  const double fraction = off_whole(order_of_line(energy, best));
  constexpr double reach_bins = 1.6;
  constexpr int wide_bins = 6;
  double all = 0, beside = 0, near = 0, narrow = 0;
  for (int k = energy.first(); k <= energy.last(); ++k) {
    if (!between_multiples(energy, k, 2)) continue;
    const double off_band = off_whole(static_cast<double>(k) / energy.turns()) - fraction;
    all += energy[k];
    if (std::abs(off_band) * energy.turns() <= reach_bins) beside += energy[k];
    if (std::abs(k - best) <= wide_bins) near += energy[k];
    if (std::abs(k - best) <= 1) narrow += energy[k];
  }
  const bool seen = all > 10 * smallest_energy;
  add(features, "energy off the sidebands of line 1", seen ? logarithm(1 - beside / all) : 0);
  add(features, "width of line 1", seen ? logarithm(1 - narrow / near) : 0);
}

/// Even multiples over odd ones: what two equal sides do alike has no even ones.
void add_parity(const HannEnergy& energy, Features& features) {
  double even = 0, odd = 0;
  constexpr int most_multiple = 7;
  for (int order = 2; order <= most_multiple; ++order)
    (order % 2 == 0 ? even : odd) += energy.near(order, 1) + energy.near(-order, 1);
  add(features, "even over odd multiples", logarithm(even) - logarithm(odd));
}

/// A fifth of all lines are weaker than this.
void add_noise(const HannEnergy& energy, Features& features) {
  std::vector<double> between;
  for (int k = energy.first(); k <= energy.last(); ++k)
    if (between_multiples(energy, k, 2)) between.push_back(energy[k]);
  const auto fifth = between.begin() + static_cast<std::ptrdiff_t>(between.size() / 5);
  std::ranges::nth_element(between, fifth);
  add(features, "noise", std::log10(std::max(*fifth, 1e-14)));
}

/// Orders a + b = c + d (times 2): the phase of A_a A_b / (A_c A_d) does not change when the motion is turned
/// or recorded from another mark.
struct PhaseRelation {
  std::array<int, 2> gained, lost;
};
constexpr std::array plane_relations{PhaseRelation{{6, -2}, {2, 2}},  PhaseRelation{{4, -2}, {-4, 6}},
                                     PhaseRelation{{4, -4}, {2, -2}}, PhaseRelation{{4, 4}, {2, 6}},
                                     PhaseRelation{{1, 3}, {2, 2}},   PhaseRelation{{-1, 3}, {1, 1}},
                                     PhaseRelation{{1, -1}, {2, -2}}};

/// The phase as a point inside the unit circle, which is nearer to the middle where the lines are weak.
void add_phases(const MotionLines& lines, Features& features) {
  const double size = size_of(lines);
  const auto line = [&](int half_orders) {
    const int twice = half_orders * lines.turns, k = twice / 2;
    return twice % 2 != 0 || std::abs(k) > lines.last() ? Complex(0) : lines.at(k);
  };
  constexpr double visible = 0.01;  // of the size: half of the length of a phase's arrow
  const auto arrow = [&](int half_orders) {
    const Complex a = line(half_orders);
    return a / (std::abs(a) + visible * size);
  };
  for (const PhaseRelation& r : plane_relations) {
    const Complex phase =
        arrow(r.gained[0]) * arrow(r.gained[1]) * std::conj(arrow(r.lost[0]) * arrow(r.lost[1]));
    const std::string name =
        fmt::format("phase of {}/2, {}/2 to {}/2, {}/2", r.gained[0], r.gained[1], r.lost[0], r.lost[1]);
    add(features, name + ", cosine", phase.real());
    add(features, name + ", sine", phase.imag());
  }
}

/// The same of one probe: A_b / A_a^m, where b = m a.
void add_phases_of_one_probe(const MotionLines& lines, Features& features) {
  const double size = size_of(lines);
  struct Relation {
    int half_orders, times, of;
  };
  for (const Relation r : {Relation{4, 2, 2}, {6, 3, 2}, {2, 2, 1}, {3, 3, 1}, {8, 4, 2}}) {
    const auto arrow = [&](int half_orders) {
      const int twice = half_orders * lines.turns, k = twice / 2;
      const Complex a = twice % 2 != 0 || k > lines.last() ? Complex(0) : lines.at(k);
      return a / (std::abs(a) + 0.01 * size);
    };
    const Complex phase = arrow(r.half_orders) * std::conj(std::pow(arrow(r.of), r.times));
    const std::string name = fmt::format("phase of {}/2 to {} times {}/2", r.half_orders, r.times, r.of);
    add(features, name + ", cosine", phase.real());
    add(features, name + ", sine", phase.imag());
  }
}

}  // namespace

Features line_features(const MotionLines& lines, bool plane) {
  const HannEnergy energy(lines, plane);
  Features features;
  add_multiples(energy, plane, features);
  add_fractions(energy, features);
  add_rest(energy, features);
  add_strongest(energy, features);
  add_sidebands(energy, features);
  add_parity(energy, features);
  add_noise(energy, features);
  if (plane) {
    add_phases(lines, features);
  } else {
    add_phases_of_one_probe(lines, features);
  }
  return features;
}

}  // namespace rubsweep::diagnose::features
