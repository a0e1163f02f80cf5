#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/core/response/spectrum/orbit_shape.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::response::motion {

/// Contact quantities that the integrator observed over one turn or several.
struct ContactFacts {
  int hits = 0;                    ///< contacts that began
  double contact_fraction = 0;     ///< time in contact / time; 1 with 0 hits is a rotor that slides all along
  double peak_displacement_m = 0;  ///< largest |z|
  double peak_contact_force_n = 0;        ///< largest total force at one stop
  double peak_casing_displacement_m = 0;  ///< largest distance of a casing from its unloaded place
  double peak_twist_rad = 0;              ///< largest angle between rotor and drive
  double peak_torque_nm = 0;              ///< largest torque in the drive
};

/// Facts of one complete turn.
ContactFacts facts_of(const integrate::run::TurnReport& turn);

/// Facts of several turns: hits added up, the mean share of time, the largest peaks.
ContactFacts together(std::span<const ContactFacts> turns);

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

constexpr std::string_view to_string(MotionStatus status) { return enumerator_word(status); }

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

/// Evidence for the class of a motion; each word says what is shown, up to rounding.
enum class Proof {
  rest,     ///< a bound on the free vibration: no contact can ever come again
  floquet,  ///< the run is inside a ball about a periodic orbit from which every motion converges to it
  /// Newton's iteration finds a periodic orbit (in a rotationally symmetric scene: a circle or a closed orbit
  /// in the frame that turns with the shaft) with all its multipliers inside the unit circle, and the run has
  /// been followed towards it over orders of magnitude; no ball about it is known.
  floquet_observed,
  observed,  ///< the end of the run decides: windows that agree, a comb that closes, an exponent
};

constexpr std::string_view to_string(Proof proof) { return enumerator_word(proof); }

/// A motion that a transient is proven to settle on.
struct ProvenMotion {
  MotionClass motion_class = MotionClass::synchronous;  ///< class of a period, or quasi_periodic
  std::optional<int> order;                             ///< period in turns; empty when quasi-periodic
  Measures measures;                                    ///< measures of the orbit itself
  double floquet_modulus = 0;                           ///< largest multiplier over its period, < 1
  Proof proof = Proof::floquet_observed;                ///< or floquet
};

}  // namespace rubsweep::response::motion
