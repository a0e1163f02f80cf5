#include "rubsweep/measurement/diagnose/features/described_motion.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <string>

#include "rubsweep/measurement/diagnose/features/line_features.hpp"
#include "rubsweep/measurement/diagnose/features/waveform_features.hpp"

namespace rubsweep::diagnose::features {
namespace {

using Complex = std::complex<double>;

/// A line's phase with a length below 1, which is less where the line is weak; nothing where none is seen.
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
  double visible_;  ///< amplitude of half the length
};

void add_phase(const std::string& name, Complex phase, Features& features) {
  add(features, name + ", cosine", phase.real());
  add(features, name + ", sine", phase.imag());
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

/// Phases of forward and backward lines, which two probes tell.
void add_phases(const Arrows& arrow, Features& features) {
  for (const PhaseRelation& r : plane_relations)
    add_phase(
        fmt::format("phase of {}/2, {}/2 to {}/2, {}/2", r.gained[0], r.gained[1], r.lost[0], r.lost[1]),
        arrow(r.gained[0]) * arrow(r.gained[1]) * std::conj(arrow(r.lost[0]) * arrow(r.lost[1])), features);
}

/// The same of one probe: A_b / A_a^m, where b = m a.
void add_phases_of_one_probe(const Arrows& arrow, Features& features) {
  struct Relation {
    int half_orders, times, of;
  };
  for (const Relation r : {Relation{4, 2, 2}, {6, 3, 2}, {2, 2, 1}, {3, 3, 1}, {8, 4, 2}})
    add_phase(fmt::format("phase of {}/2 to {} times {}/2", r.half_orders, r.times, r.of),
              arrow(r.half_orders) * std::conj(std::pow(arrow(r.of), r.times)), features);
}

using Complex = std::complex<double>;

void add_direction(const std::string& name, double angle_rad, Features& features) {
  add(features, "cosine of " + name, std::cos(angle_rad));
  add(features, "sine of " + name, std::sin(angle_rad));
}

/// Along the lopsided direction and to its left, so that it stays the same when all is turned.
void add_mean(const MotionLines& lines, const View& view, const DescribedMotion& motion, Features& features) {
  const Complex mean = lines.at(0) / motion.size_m * std::polar(1.0, -motion.direction_rad);
  add(features, view.plane ? "mean position along lopsided direction" : "mean position", mean.real());
  if (view.plane) add(features, "mean position across lopsided direction", mean.imag());
}

}  // namespace

Features phase_features(const MotionLines& lines, bool plane) {
  const Arrows arrow(lines);
  Features features;
  if (plane) {
    add_phases(arrow, features);
  } else {
    add_phases_of_one_probe(arrow, features);
  }
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
