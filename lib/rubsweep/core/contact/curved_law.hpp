#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/model/normal_law.hpp"
#include "rubsweep/core/numerics/pchip.hpp"

namespace rubsweep::model {
struct Stop;
}

namespace rubsweep::contact {

/// Factor x = c v0 of the force S(p) (1 + c p') of an impact that begins with the speed v0. Formulas: Hunt &
/// Crossley (1975) 3 (1 - e) / 2, Lankarani & Nikravesh (1990) 3 (1 - e^2) / 4, Flores et al. (2011) 8 (1 -
/// e) / (5 e). `delivered` is the factor for which a free impact has the restitution e: (1 + e) x = ln((1 +
/// x) / (1 - e x)), the first integral of m p'' = -S(p) (1 + c p'), valid for every S.
double damping_factor(model::ImpactDamping damping, double restitution);

/// Restitution e in (0, 1] of a free impact with this factor, by the same first integral.
double restitution_of_factor(double factor);

/// Normal force of a contact with a curved characteristic: S(p) (1 + c p'), or 0 where this would pull. S(0)
/// = 0, and S rises. Newtons and metres. S is odd: values at p < 0 occur only where a step overshoots.
class CurvedLaw {
 public:
  explicit CurvedLaw(const model::Stop& stop);

  double force_n(double penetration_m) const;
  double slope_n_per_m(double penetration_m) const;
  /// Elastic energy in joules: integral of S from 0 to a penetration >= 0.
  double energy_j(double penetration_m) const;
  /// Rising penetrations where S is smooth on each side only: its second derivative jumps there.
  const std::vector<double>& knots_m() const { return knots_m_; }

  const model::NormalLaw& law() const { return law_; }
  /// Damping factor x = c v0, without unit.
  double factor() const { return factor_; }
  /// Approach speed v0 used for all impacts; empty: each impact uses its own speed.
  const std::optional<double>& approach_m_per_s() const { return law_.approach_speed_m_per_s; }
  /// Smallest approach speed that is used unchanged, in clearances per radian of rotation. Without this bound
  /// the damping of a graze would be unlimited.
  static constexpr double slowest_approach = 1e-3;

  bool remembers() const { return factor_ > 0 && !law_.approach_speed_m_per_s; }

 private:
  double line_force_n(double penetration_m) const;

  model::NormalLaw law_;
  double factor_ = 0;
  /// The line contact of Hertz has p = a F (b - ln F / 2) up to the force at which the contact is as wide as
  /// long, and the tangent there for larger forces. Inverse: F = -2 q / W(-2 q e^{-2 b}), q = p / a, with the
  /// lower branch of Lambert's function W.
  double a_ = 0, b_ = 0;
  numerics::Pchip table_;
  double end_m_ = 0, end_n_ = 0, end_slope_ = 0;  ///< start of the tangent beyond a line contact or table
  std::vector<double> knots_m_;
};

/// The elastic force of a law in words, for --explain.
std::string describe(const model::NormalLaw& law);

/// Secant stiffness of a non-linear law at a penetration of 1/20 of the clearance, in N/m. Used to estimate
/// the stiffness of a contact.
double secant_n_per_m(const model::Stop& stop);

/// Mode of a contact with c = `damping`: open, sprung, or released where the force would pull.
constexpr Mode curved_mode(double damping, double penetration, double closing_speed) {
  if (penetration <= 0) return Mode::open;
  return 1 + damping * closing_speed <= 0 ? Mode::released : Mode::sprung;
}

/// Guards of a mode of a curved contact, in the convention of guards_of.
constexpr Guards curved_guards(Mode mode, double damping, const Kinematics& k) {
  if (mode == Mode::open) return {{{{k.penetration, k.closing_speed, Mode::sprung}, {}}}, 1};
  const Guard opens{-k.penetration, -k.closing_speed, Mode::open};
  const double sign = mode == Mode::released ? 1 : -1;
  const Guard pulls{sign * (1 + damping * k.closing_speed), sign * damping * k.closing_acceleration,
                    mode == Mode::released ? Mode::sprung : Mode::released};
  return {{opens, pulls}, damping > 0 ? 2 : 1};
}

}  // namespace rubsweep::contact
