#include "rubsweep/measurement/diagnose/features/line_features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

namespace rubsweep::diagnose::features {
namespace {

constexpr double smallest_energy = 1e-7;  ///< share of the energy below which a line counts as absent
constexpr int most_fraction = 5;          ///< fractions of the speed: 1/2 down to 1/5

double logarithm(double share) { return std::log10(std::max(share, smallest_energy)); }

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

/// Energy between the multiples of the shaft speed: the total, the backward part, and the part below 1X.
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

/// The two strongest lines that are not near a multiple of the shaft speed.
void add_strongest(const HannEnergy& energy, Features& features) {
  std::vector<int> found;
  for (int rank = 1; rank <= 2; ++rank) {
    const int best = strongest_between_multiples(energy, found);
    const double share = best == 0 ? 0 : energy[best - 1] + energy[best] + energy[best + 1];
    add(features, fmt::format("order of line {} between multiples", rank),
        share > 10 * smallest_energy ? order_of_line(energy, best) : 0);
    add(features, fmt::format("energy of line {} between multiples", rank), logarithm(share));
    found.push_back(best);
  }
}

/// Distance of an order to the nearest whole number.
double off_whole(double order) { return std::abs(order - std::round(order)); }

/// Three measures of the strongest line between the multiples of the shaft speed: the energy there that lies
/// outside its sidebands (whole orders plus or minus its order), the energy that lies off this order forward
/// and backward, and its width. The first and the last are small for a fraction or a torus, and large for
/// chaos and for several causes. The second is small for a vibration that no contact mixes with 1X.
void add_sidebands(const HannEnergy& energy, Features& features) {
  const int best = strongest_between_multiples(energy, {});
  const double fraction = off_whole(order_of_line(energy, best));
  constexpr double reach_bins = 1.6;
  constexpr int wide_bins = 6, own_bins = 3;
  double all = 0, beside = 0, own = 0, near = 0, narrow = 0;
  for (int k = energy.first(); k <= energy.last(); ++k) {
    if (!between_multiples(energy, k, 2)) continue;
    const double off_band = off_whole(static_cast<double>(k) / energy.turns()) - fraction;
    all += energy[k];
    if (std::abs(off_band) * energy.turns() <= reach_bins) beside += energy[k];
    if (std::abs(std::abs(k) - std::abs(best)) <= own_bins) own += energy[k];
    if (std::abs(k - best) <= wide_bins) near += energy[k];
    if (std::abs(k - best) <= 1) narrow += energy[k];
  }
  const bool seen = all > 10 * smallest_energy;
  add(features, "energy off the sidebands of line 1 between multiples",
      seen ? logarithm(1 - beside / all) : 0);
  add(features, "energy off the order of line 1 between multiples", seen ? logarithm(1 - own / all) : 0);
  add(features, "width of line 1 between multiples", seen ? logarithm(1 - narrow / near) : 0);
}

/// Energy of even multiples divided by that of odd multiples; two equal stops on opposite sides excite no
/// even multiples.
void add_parity(const HannEnergy& energy, Features& features) {
  double even = 0, odd = 0;
  constexpr int most_multiple = 7;
  for (int order = 2; order <= most_multiple; ++order)
    (order % 2 == 0 ? even : odd) += energy.near(order, 1) + energy.near(-order, 1);
  add(features, "even over odd multiples", logarithm(even) - logarithm(odd));
}

/// Straightness of the motion and of its acceleration, for all lines off 1X, for those at multiples of the
/// shaft speed and for those between them, as -log10(1 - straightness).
void add_straightness(const MotionLines& lines, const HannEnergy& energy, Features& features) {
  enum class Part { all, multiples, between };
  constexpr std::array parts{Part::all, Part::multiples, Part::between};
  constexpr std::array<const char*, parts.size()> names{"off 1X", "at multiples", "between multiples"};
  for (const bool acceleration : {false, true})
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const Part part = parts[p];
      const double straight = straightness(lines, [&](int k) {
        constexpr int line_bins = 2;
        const bool off_1x = std::abs(std::abs(k) - lines.turns) > line_bins,
                   between = between_multiples(energy, k, line_bins);
        if (!off_1x || (part != Part::all && between != (part == Part::between))) return 0.0;
        const double order = static_cast<double>(k) / lines.turns;
        return acceleration ? order * order : 1.0;
      });
      constexpr double least_off = 1e-3;
      add(features, fmt::format("straightness of {} {}", acceleration ? "acceleration" : "motion", names[p]),
          -std::log10(std::max(1 - straight, least_off)));
    }
}

/// Noise level: the energy below which a fifth of the lines between the multiples lie.
void add_noise(const HannEnergy& energy, Features& features) {
  std::vector<double> between;
  for (int k = energy.first(); k <= energy.last(); ++k)
    if (between_multiples(energy, k, 2)) between.push_back(energy[k]);
  const auto fifth = between.begin() + static_cast<std::ptrdiff_t>(between.size() / 5);
  std::ranges::nth_element(between, fifth);
  add(features, "noise", std::log10(std::max(*fifth, 1e-14)));
}

}  // namespace

void add(Features& features, std::string name, double value) { features.push_back({std::move(name), value}); }

HannEnergy::HannEnergy(const MotionLines& lines, bool plane)
    : turns_(lines.turns), last_(lines.last()), first_(plane ? -last_ : 1) {
  const double all = size_of(lines) * size_of(lines) * (plane ? 1 : 0.5);
  share_.assign(2 * static_cast<std::size_t>(last_) + 1, 0);
  for (int k = first_; k <= last_; ++k) {
    if (k == 0) continue;
    const auto line = [&](int j) {
      return j == 0 || std::abs(j) > last_ ? std::complex<double>(0) : lines.at(j);
    };
    // The Hann window keeps 3/8 of the energy of a line at the centre of a bin.
    share_[index(k)] = std::norm(line(k) / 2.0 - (line(k - 1) + line(k + 1)) / 4.0) * 8 / 3 / all;
  }
}

double HannEnergy::near(double order, int bins) const {
  const int middle = static_cast<int>(std::lround(order * turns_));
  double sum = 0;
  for (int k = middle - bins; k <= middle + bins; ++k) sum += (*this)[k];
  return sum;
}

bool between_multiples(const HannEnergy& energy, int k, int bins) {
  const double order = static_cast<double>(k) / energy.turns();
  return std::abs(k - std::lround(order) * energy.turns()) > bins;
}

int strongest_between_multiples(const HannEnergy& energy, const std::vector<int>& others) {
  constexpr int apart = 2;
  int best = 0;
  for (int k = energy.first(); k <= energy.last(); ++k) {
    const bool taken = std::ranges::any_of(others, [&](int other) { return std::abs(k - other) <= apart; });
    if (between_multiples(energy, k, apart) && !taken && energy[k] > energy[best]) best = k;
  }
  return best;
}

double order_of_line(const HannEnergy& energy, int k) {
  const auto height = [&](int j) { return std::log(std::max(energy[j], 1e-300)); };
  const double left = height(k - 1), middle = height(k), right = height(k + 1),
               bend = left - 2 * middle + right;
  const double shift = bend < 0 ? std::clamp((left - right) / (2 * bend), -0.5, 0.5) : 0;
  return (k + shift) / energy.turns();
}

Features line_features(const MotionLines& lines, bool plane) {
  const HannEnergy energy(lines, plane);
  Features features;
  add_multiples(energy, plane, features);
  add_fractions(energy, features);
  add_rest(energy, features);
  add_strongest(energy, features);
  add_sidebands(energy, features);
  add_parity(energy, features);
  if (plane) add_straightness(lines, energy, features);
  add_noise(energy, features);
  return features;
}

}  // namespace rubsweep::diagnose::features
