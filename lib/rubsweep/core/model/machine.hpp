#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/core/model/stop.hpp"

namespace rubsweep::model {

/// Jeffcott rotor: one disc in the middle of a massless isotropic shaft, with the displacement z = x + iy and
/// m z'' + c z' + k z = forces. (Ishibashi & Kawai, section 3; the lowest bending frequency is their
/// epsilon_L.)
struct JeffcottRotor {
  double mass_kg = required;
  double natural_frequency_hz = required;  ///< undamped, sqrt(k/m)/(2 pi)
  double damping_ratio = required;         ///< c / (2 sqrt(k m)); 0 and values above 1 are allowed
  /// Ratio of the damping that rotates with the shaft (in its material and joints), as for damping_ratio: the
  /// force is -c_r (z' - i w z) with c_r = 2 sqrt(k m) times this ratio. Above the speed sqrt(k/m) (1 +
  /// damping_ratio / this ratio) the shaft is unstable and starts to whirl by itself.
  double rotating_damping_ratio = 0;

  static void visit_fields(auto& self, auto&& visit) {
    visit("mass_kg", self.mass_kg, key(positive, "mass of the disc: the modal mass there"));
    visit("natural_frequency_hz", self.natural_frequency_hz,
          key(positive, "undamped natural frequency, sqrt(k/m)/(2 pi)"));
    visit(
        "damping_ratio", self.damping_ratio,
        key(not_negative, "damping as a fraction of critical damping, c / (2 sqrt(k m)); of a kit by mode"));
    visit("rotating_damping_ratio", self.rotating_damping_ratio,
          newer_key(not_negative,
                    "the same of the damping that turns with the shaft, in its material and joints"));
  }
};

/// Half-sine force pulse on the rotor, F(t) = force_n sin(pi t / duration_s) for 0 <= t <= duration_s. t = 0
/// is the instant of smallest gap at the first stop, or the instant when the shaft has turned by phase_deg
/// after it. By default the pulse points at that stop's wall.
struct Kick {
  double force_n = required;
  double duration_s = required;
  std::optional<double> angle_deg;  ///< direction, from +x towards +y; empty: towards the first stop's wall
  /// Position of the force along the shaft of a rotor kit; empty: at the first stop.
  std::optional<double> position_m = std::nullopt;
  std::optional<double> phase_deg = std::nullopt;  ///< empty: 0

  static void visit_fields(auto& self, auto&& visit) {
    visit("force_n", self.force_n, key(not_negative, "largest force of the half-sine pulse"));
    visit("duration_s", self.duration_s, key(positive, "length of the pulse"));
    visit("angle_deg", self.angle_deg,
          key(any_finite, "direction, from +x towards +y", "(wall of the first stop)"));
    visit("phase_deg", self.phase_deg,
          key(any_finite, "how far the shaft has turned on from the smallest gap when it comes", "0"));
  }
};

/// Position and velocity of a body. A number that is not given keeps its value on the quiet whirl (at rest,
/// if the quiet whirl reaches a wall).
struct BodyState {
  std::optional<double> x_m{}, y_m{};  ///< displacement from the unloaded position
  std::optional<double> vx_m_per_s{}, vy_m_per_s{};

  static void visit_fields(auto& self, auto&& visit) {
    constexpr Range displacement{.low = -1e2, .high = 1e2}, velocity{.low = -1e6, .high = 1e6};
    visit("x_m", self.x_m,
          newer_key(displacement, "displacement in x from the unloaded position", "(quiet whirl)"));
    visit("y_m", self.y_m,
          newer_key(displacement, "displacement in y from the unloaded position", "(quiet whirl)"));
    visit("vx_m_per_s", self.vx_m_per_s, newer_key(velocity, "velocity in x", "(quiet whirl)"));
    visit("vy_m_per_s", self.vy_m_per_s, newer_key(velocity, "velocity in y", "(quiet whirl)"));
  }
};

/// State in which a run begins; t = 0 is the instant of smallest gap at the first stop.
struct Start {
  BodyState rotor{};
  /// casings of the stops; an empty or missing entry: not given
  std::vector<std::optional<BodyState>> casings{};
  /// True: the structure is at rest in its unloaded position, and the numbers above are ignored. The mark of
  /// the shaft points along +x at t = 0, and all forces act from then on.
  bool at_rest = false;
};

/// Whether a start is given and begins at rest.
inline bool begins_at_rest(const std::optional<Start>& start) { return start && start->at_rest; }

/// A rotor of either kind.
using Rotor = std::variant<JeffcottRotor, RotorKit>;

/// All physical data that stay the same over a sweep. The kick acts at the first stop listed.
struct Machine {
  Rotor rotor;
  std::vector<Stop> stops;
  std::optional<Kick> kick;
  double gravity_m_per_s2 = 0;   ///< acceleration along -y of rotor and moving casings; >= 0
  std::optional<Start> start{};  ///< start state; excludes a kick
};

/// Rotor kit of the machine; null for another kind of rotor.
inline const RotorKit* kit_of(const Machine& machine) { return std::get_if<RotorKit>(&machine.rotor); }
inline RotorKit* kit_of(Machine& machine) { return std::get_if<RotorKit>(&machine.rotor); }

/// Throws ConfigError naming the first number that is missing or out of range. The YAML reader reports the
/// same limits with their place in the file; this check is for programs that use the library directly.
void validate(const Machine& machine);

}  // namespace rubsweep::model
