#include "rubsweep/diagnose/features/phase_features.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <string>

namespace rubsweep::diagnose::features {
namespace {

using Complex = std::complex<double>;

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

Features phase_features(const MotionLines& lines, bool plane) {
  Features features;
  if (plane) {
    add_phases(lines, features);
  } else {
    add_phases_of_one_probe(lines, features);
  }
  return features;
}

}  // namespace rubsweep::diagnose::features
