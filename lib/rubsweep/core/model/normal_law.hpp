#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/model/require.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::model {

/// Elastic force S(p) of a contact over its penetration p: K p with the stiffness of the stop and a clamped
/// damper; K p^n; the force of Hertz' line contact, which the stop describes; or a measured curve.
enum class ForceCurve { linear, power, hertz_line, table };
inline constexpr auto force_curves = words_of<ForceCurve>();

/// Formulas for c in the force S(p) (1 + c p'), from a restitution and the approach speed.
enum class ImpactDamping { none, hunt_crossley, lankarani_nikravesh, flores, delivered };
inline constexpr auto impact_dampings = words_of<ImpactDamping>();

/// Law of the normal force of a stop.
struct NormalLaw {
  ForceCurve kind = ForceCurve::linear;
  double stiffness_n_per_m_n = required;       ///< K of the force K p^n
  double exponent = required;                  ///< n of the force K p^n
  std::vector<double> penetration_m, force_n;  ///< points of a measured curve
  ImpactDamping damping = ImpactDamping::none;
  double restitution = required;
  /// approach speed for all impacts; empty: each impact has its own speed
  std::optional<double> approach_speed_m_per_s;

  static constexpr Range exponent_range{.low = 1, .high = 3};
  static constexpr Range restitution_range{.low = 0, .high = 1, .low_open = true};
  static constexpr std::size_t most_points = 1000;

  bool linear() const { return kind == ForceCurve::linear; }

  /// `keys` is the section being read, the printer, or the table of keys.
  static void visit_keys(auto& self, auto& keys) {
    constexpr NumberOrList points{{not_negative}, most_points};
    keys.field("kind", self.kind, newer_key(force_curves, "force over penetration"));
    keys.beside("kind", {"power"}, self.kind == ForceCurve::power, [&] {
      keys.field("stiffness_n_per_m_n", self.stiffness_n_per_m_n,
                 newer_key(positive, "K of the force K p^n, in N and m"));
      keys.field("exponent", self.exponent, newer_key(exponent_range, "n of the force K p^n"));
    });
    keys.beside("kind", {"table"}, self.kind == ForceCurve::table, [&] {
      keys.field("penetration_m", self.penetration_m,
                 newer_key(points, "penetrations of a measured curve, rising from 0", needed));
      keys.field("force_n", self.force_n, newer_key(points, "force at each of them, rising from 0", needed));
    });
    keys.beside("kind", {"power", "hertz_line", "table"}, !self.linear(), [&] {
      keys.field("damping", self.damping,
                 newer_key(impact_dampings, "formula of c in the force S(p) (1 + c p')"));
    });
    keys.beside("damping", {"hunt_crossley", "lankarani_nikravesh", "flores", "delivered"},
                !self.linear() && self.damping != ImpactDamping::none, [&] {
                  keys.field("restitution", self.restitution,
                             newer_key(restitution_range, "restitution that the formula asks for"));
                  keys.field("approach_speed_m_per_s", self.approach_speed_m_per_s,
                             newer_key(positive, "speed of approach that the formula takes for all impacts",
                                       "(that of each impact)"));
                });
  }
};

/// Checks the points of a measured curve against each other; empty: no problem.
std::optional<PartProblem> problem_of_curve(const NormalLaw& law);

/// Throws ConfigError that names a key after `path`. `with_hertz`: the stop describes a line contact.
void validate(const NormalLaw& law, bool with_hertz, const std::string& path);

}  // namespace rubsweep::model
