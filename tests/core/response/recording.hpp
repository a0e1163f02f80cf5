#pragma once

#include <functional>
#include <vector>

#include "core/response/synthetic_motion.hpp"
#include "rubsweep/core/response/motion/classify.hpp"

namespace rubsweep::response::testing {

using TimeFunction = std::function<Complex(double)>;

inline constexpr int turns = 64;
inline constexpr int per_turn = 128;
inline constexpr double clearance_m = 1e-3;
inline constexpr motion::ContactFacts touching{
    .hits = 1, .contact_fraction = 0.1, .peak_displacement_m = 1.1e-3, .peak_contact_force_n = 200};

/// Owns the data of a Window.
struct Recording {
  std::vector<Complex> displacement_m;
  std::vector<double> section_rows;
  std::vector<motion::ContactFacts> contact = std::vector<motion::ContactFacts>(turns, touching);

  motion::Window window() const {
    return {.turns = turns,
            .samples_per_revolution = per_turn,
            .clearance_m = clearance_m,
            .displacement_m = displacement_m,
            .states = 4,
            .section = section_rows,
            .contact = contact};
  }
  motion::WindowVerdict verdict() const {
    spectrum::SpectrumWorkspace workspace;
    return motion::classify_window(window(), {}, workspace);
  }
};

/// Samples z(turn), in metres, beginning at `first_turn`.
inline Recording record(const TimeFunction& z, double first_turn = 0) {
  return {.displacement_m = sample(z, first_turn, turns, per_turn),
          .section_rows = section(z, first_turn, turns, clearance_m)};
}

inline TimeFunction subharmonic(int n, double share = 0.5) {
  return [n, share](double turn) {
    return 0.6 * clearance_m * phasor(1, turn) + share * clearance_m * phasor(1.0 / n, turn);
  };
}

inline TimeFunction circle(double radius_m) {
  return [radius_m](double turn) { return radius_m * phasor(1, turn); };
}

}  // namespace rubsweep::response::testing
