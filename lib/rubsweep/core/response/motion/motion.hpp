#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/motion/contact_facts.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/core/response/spectrum/orbit_shape.hpp"

namespace rubsweep::response::motion {

/// Remarks on the evidence, beside the class.
enum class MotionStatus {
  ok,
  spectrum_disagrees,  ///< the section returned after n turns, the spectrum holds lines off the multiples of
                       ///< 1/n
  order_above_max,  ///< unsettled, and on the way to or on a section that returns after more than max_order
                    ///< turns
  transient_chaos,  ///< chaotic, and it or a companion from a nearby state left the chaos within the turns
                    ///< that they were followed for
  step_limit,       ///< unsettled: to decide would have taken more work than is allowed
};

constexpr std::string_view to_string(MotionStatus status) {
  switch (status) {
    case MotionStatus::ok:
      return "ok";
    case MotionStatus::spectrum_disagrees:
      return "spectrum_disagrees";
    case MotionStatus::order_above_max:
      return "order_above_max";
    case MotionStatus::transient_chaos:
      return "transient_chaos";
    case MotionStatus::step_limit:
      return "step_limit";
  }
  throw SolverError("motion status without a name");
}

/// Measures of one window, whatever the class of the motion.
struct Measures {
  /// Number of last turns of the window that all measures are taken from, whole periods where there is one.
  int turns = 0;
  ContactFacts contact;
  double amplitude_1x_forward_m = 0;
  double amplitude_1x_backward_m = 0;
  std::optional<spectrum::SpectralLine> dominant;  ///< largest line but 0X, of a closed comb at its exact
                                                   ///< order; empty, as orbit and whirl, when the rotor rests
  std::optional<spectrum::OrbitKind> orbit;
  std::optional<spectrum::WhirlKind> whirl;
  std::optional<double>
      comb_spacing;  ///< of a closed orbit in the rotating frame of a rotationally symmetric
                     ///< scene: lines at orders 1 + k comb_spacing, over both windows
};

/// Largest Lyapunov exponent: mean rate at which nearby motions part, per iteration of the map (for a
/// section: per revolution). Positive: chaos; zero: a torus; negative: a periodic motion that attracts.
struct Exponent {
  double per_revolution = 0;
  double error_bar = 0;  ///< half-width of the 99 % confidence interval, > 0
};

/// The settled verdict on one run.
struct Motion {
  MotionClass motion_class = MotionClass::unsettled;
  std::optional<int> order;  ///< n of a motion with contact that repeats after n turns, else empty
  MotionStatus status = MotionStatus::ok;
  Measures measures;
  std::optional<Exponent> exponent;  ///< measured where two windows and a comb did not decide
};

}  // namespace rubsweep::response::motion
