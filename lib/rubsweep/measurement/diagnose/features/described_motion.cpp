#include "rubsweep/measurement/diagnose/features/described_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace rubsweep::diagnose::features {
namespace {

using Complex = std::complex<double>;
using Eigen::ArrayXd;

/// Adds the extent and the moments of a signal in units of its root mean square.
void add_moments(const std::string& name, const ArrayXd& x, Features& features) {
  const double size = std::max(std::sqrt(x.square().mean()), 1e-300);
  const ArrayXd unit = x / size;
  add(features, "skewness of " + name, unit.cube().mean());
  add(features, "kurtosis of " + name, unit.square().square().mean());
  std::vector<double> sorted(unit.begin(), unit.end());
  std::ranges::sort(sorted);
  const auto quantile = [&](double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  add(features, "least " + name, quantile(0.01));
  add(features, "largest " + name, quantile(0.99));
}

/// Samples shifted by one step, cyclically: the first sample follows the last one.
template <class Array>
Array after(const Array& x) {
  Array shifted(x.size());
  shifted << x.tail(x.size() - 1), x(0);
  return shifted;
}

/// Kurtosis and skewness of the second difference, which is large where a contact force bends the signal.
void add_bends(const std::string& name, const ArrayXd& x, Features& features) {
  const ArrayXd rise = after(x) - x, bend = after(rise) - rise;
  const double size = std::max(std::sqrt(bend.square().mean()), 1e-300);
  add(features, "kurtosis of acceleration " + name, (bend / size).square().square().mean());
  add(features, "skewness of acceleration " + name, (bend / size).cube().mean());
}

/// Phase of a line as a complex number of magnitude below 1; the magnitude is small for a weak line and 0 for
/// an absent line.
class Arrows {
 public:
  explicit Arrows(const MotionLines& lines) : lines_(lines), visible_(0.01 * size_of(lines)) {}

  Complex operator()(int half_orders) const {
    const int twice = half_orders * lines_.turns, k = twice / 2;
    const Complex line = twice % 2 != 0 || std::abs(k) > lines_.last() ? Complex(0) : lines_.at(k);
    return line / (std::abs(line) + visible_);
  }

 private:
  const MotionLines& lines_;
  double visible_;  ///< amplitude at which the magnitude is 1/2
};

void add_phase(const std::string& name, Complex phase, Features& features) {
  add(features, name + ", cosine", phase.real());
  add(features, name + ", sine", phase.imag());
}

/// Orders (times 2) with a + b = c + d: the phase of A_a A_b / (A_c A_d) does not change when the motion is
/// rotated or recorded from another mark.
struct PhaseRelation {
  std::array<int, 2> gained, lost;
};
constexpr std::array plane_relations{PhaseRelation{{6, -2}, {2, 2}},  PhaseRelation{{4, -2}, {-4, 6}},
                                     PhaseRelation{{4, -4}, {2, -2}}, PhaseRelation{{4, 4}, {2, 6}},
                                     PhaseRelation{{1, 3}, {2, 2}},   PhaseRelation{{-1, 3}, {1, 1}},
                                     PhaseRelation{{1, -1}, {2, -2}}};

/// Adds phase relations of forward and backward lines, which need two probes.
void add_phases(const Arrows& arrow, Features& features) {
  for (const PhaseRelation& r : plane_relations)
    add_phase(
        fmt::format("phase of {}/2, {}/2 to {}/2, {}/2", r.gained[0], r.gained[1], r.lost[0], r.lost[1]),
        arrow(r.gained[0]) * arrow(r.gained[1]) * std::conj(arrow(r.lost[0]) * arrow(r.lost[1])), features);
}

/// Adds phase relations for one probe: A_b / A_a^m with b = m a.
void add_phases_of_one_probe(const Arrows& arrow, Features& features) {
  struct Relation {
    int half_orders, times, of;
  };
  for (const Relation r : {Relation{4, 2, 2}, {6, 3, 2}, {2, 2, 1}, {3, 3, 1}, {8, 4, 2}})
    add_phase(fmt::format("phase of {}/2 to {} times {}/2", r.half_orders, r.times, r.of),
              arrow(r.half_orders) * std::conj(std::pow(arrow(r.of), r.times)), features);
}

void add_direction(const std::string& name, double angle_rad, Features& features) {
  add(features, "cosine of " + name, std::cos(angle_rad));
  add(features, "sine of " + name, std::sin(angle_rad));
}

/// Adds the mean, resolved along the lopsided direction and to its left; rotations do not change it.
void add_mean(const MotionLines& lines, const View& view, const DescribedMotion& motion, Features& features) {
  const Complex mean = lines.at(0) / motion.size_m * std::polar(1.0, -motion.direction_rad);
  add(features, view.plane ? "mean position along lopsided direction" : "mean position", mean.real());
  if (view.plane) add(features, "mean position across lopsided direction", mean.imag());
}

}  // namespace

double lopsided_direction(const Eigen::VectorXcd& waveform) {
  return std::arg((waveform.array().abs2() * waveform.array()).mean());
}

Features orbit_features(const Eigen::VectorXcd& waveform) {
  Features features;
  const auto z = waveform.array();
  const double size = std::max(std::sqrt(z.abs2().mean()), 1e-300);
  const Complex oval = z.square().mean() / (size * size),
                lopsided = (z.abs2() * z).mean() / std::pow(size, 3),
                corners = z.cube().mean() / std::pow(size, 3);
  add(features, "ovality", std::abs(oval));
  add(features, "lopsidedness", std::abs(lopsided));
  add(features, "three corners", std::abs(corners));
  const Complex direction = std::polar(1.0, std::arg(lopsided));
  add(features, "ovality along the lopsided direction", std::real(oval / (direction * direction)));
  add(features, "ovality across the lopsided direction", std::imag(oval / (direction * direction)));
  add(features, "corners along the lopsided direction", std::real(corners / std::pow(direction, 3)));
  const Eigen::ArrayXcd turned = z / direction;
  add_moments("extent along", turned.real(), features);
  add_moments("extent across", turned.imag(), features);
  add_bends("along", turned.real(), features);
  add_bends("across", turned.imag(), features);
  std::vector<double> radii;
  for (const Complex w : turned) radii.push_back(std::abs(w) / size);
  std::ranges::sort(radii);
  const auto radius = [&](double share) {
    return radii[static_cast<std::size_t>(share * static_cast<double>(radii.size() - 1))];
  };
  for (const double share : {0.01, 0.25, 0.5, 0.75, 0.99})
    add(features, "radius of " + std::to_string(static_cast<int>(100 * share)) + " %", radius(share));
  const ArrayXd swept = (turned.conjugate() * after(turned)).imag() / (size * size);
  add(features, "mean whirl", swept.mean());
  add(features, "share of backward whirl", (swept < 0).cast<double>().mean());
  return features;
}

Features signal_features(const Eigen::VectorXd& waveform) {
  Features features;
  add_moments("signal", waveform.array(), features);
  add_bends("of the signal", waveform.array(), features);
  return features;
}

Features phase_features(const MotionLines& lines, bool plane) {
  const Arrows arrow(lines);
  Features features;
  (plane ? add_phases : add_phases_of_one_probe)(arrow, features);
  return features;
}

DescribedMotion describe(const MotionLines& lines, const View& view,
                         response::spectrum::SpectrumWorkspace& workspace) {
  constexpr int samples_of_a_turn = 32;
  const Eigen::VectorXcd waveform = waveform_of(lines, samples_of_a_turn, workspace);
  DescribedMotion motion{line_features(lines, view.plane), size_of(lines),
                         view.plane ? lopsided_direction(waveform) : 0};
  for (const Features& further : {phase_features(lines, view.plane),
                                  view.plane ? orbit_features(waveform) : signal_features(waveform.real())})
    motion.features.insert(motion.features.end(), further.begin(), further.end());
  if (view.plane && view.directions) {
    add_direction("lopsided direction", motion.direction_rad, motion.features);
    // An ellipse a e^{i phi} + b e^{-i phi} is longest along half the angle of a b.
    add_direction("twice the direction in which 1X is longest",
                  std::arg(lines.at(lines.turns) * lines.at(-lines.turns)), motion.features);
  }
  if (view.from_rest) add_mean(lines, view, motion, motion.features);
  return motion;
}

Eigen::VectorXd values_of(const Features& features) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(features.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) values(i) = features[static_cast<std::size_t>(i)].value;
  return values;
}

}  // namespace rubsweep::diagnose::features
