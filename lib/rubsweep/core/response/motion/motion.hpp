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
  int hits = 0;                           ///< contacts that began
  double contact_fraction = 0;            ///< time in contact / time; 1 with 0 hits: slides without a break
  double peak_displacement_m = 0;         ///< largest distance |z| of the rotor
  double peak_contact_force_n = 0;        ///< largest total force at one stop
  double peak_casing_displacement_m = 0;  ///< largest distance of a casing from its unloaded position
  double peak_twist_rad = 0;              ///< largest angle between rotor and drive
  double peak_torque_nm = 0;              ///< largest torque in the drive
};

/// Facts of one complete turn.
ContactFacts facts_of(const integrate::run::TurnReport& turn);

/// Facts of several turns: sum of hits, mean share of contact, largest peaks.
ContactFacts together(std::span<const ContactFacts> turns);

/// Remark on the evidence, in addition to the class.
enum class MotionStatus {
  ok,
  spectrum_disagrees,  ///< the section returned after n turns, but the spectrum has lines off the multiples
                       ///< of 1/n
  order_above_max,     ///< unsettled: the section returns, or will return, after more than max_order turns
  transient_chaos,     ///< chaotic, but the motion or a companion from a nearby state left the chaos while it
                       ///< was followed
  step_limit,          ///< unsettled: a decision would have needed more work than allowed
};

constexpr std::string_view to_string(MotionStatus status) { return enumerator_word(status); }

/// Measures of one window, for a motion of any class.
struct Measures {
  /// Number of last turns of the window used for all measures; whole periods where there is a period.
  int turns = 0;
  ContactFacts contact;
  double amplitude_1x_forward_m = 0;
  double amplitude_1x_backward_m = 0;
  /// largest line except 0X, at its exact order for a closed comb; like orbit and whirl, empty when the rotor
  /// rests
  std::optional<spectrum::SpectralLine> dominant;
  std::optional<spectrum::OrbitKind> orbit;
  std::optional<spectrum::WhirlKind> whirl;
  std::optional<double> comb_spacing;  ///< spacing of lines at orders 1 + k comb_spacing over both windows: a
                                       ///< closed orbit in the rotating frame of a symmetric scene
};

/// Largest Lyapunov exponent: mean rate at which nearby motions separate, per iteration of the map (for a
/// section: per revolution). Positive: chaos; zero: a torus; negative: an attracting periodic motion.
struct Exponent {
  double per_revolution = 0;
  double error_bar = 0;  ///< half-width of the 99 % confidence interval, > 0
};

/// Final verdict on one run.
struct Motion {
  MotionClass motion_class = MotionClass::unsettled;
  std::optional<int> order;  ///< n for a motion with contact that repeats after n turns, otherwise empty
  MotionStatus status = MotionStatus::ok;
  Measures measures;
  std::optional<Exponent> exponent;  ///< measured where neither two windows nor a comb decided
};

/// Evidence for the class of a motion; each word names what is proven, up to rounding.
enum class Proof {
  rest,     ///< a bound on the free vibration: contact can never occur again
  floquet,  ///< the run is inside a ball about a periodic orbit from which every motion converges to it
  /// Newton's iteration finds a periodic orbit with all multipliers inside the unit circle (in a rotationally
  /// symmetric scene: a circle or a closed orbit in the rotating frame). The run has been followed towards
  /// the orbit over orders of magnitude, but no ball about it is known.
  floquet_observed,
  observed,  ///< the end of the run decides: windows that agree, a comb that closes, or an exponent
};

constexpr std::string_view to_string(Proof proof) { return enumerator_word(proof); }

/// A motion that a transient provably approaches.
struct ProvenMotion {
  MotionClass motion_class = MotionClass::synchronous;  ///< a periodic class, or quasi_periodic
  std::optional<int> order;                             ///< period in turns; empty when quasi-periodic
  Measures measures;                                    ///< measures of the orbit, not of the transient
  double floquet_modulus = 0;                           ///< largest multiplier over its period, < 1
  Proof proof = Proof::floquet_observed;                ///< floquet_observed or floquet
};

}  // namespace rubsweep::response::motion
