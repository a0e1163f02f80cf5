#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/model/normal_law.hpp"
#include "rubsweep/core/numerics/pchip.hpp"

namespace rubsweep::model {
struct Stop;
}

namespace rubsweep::contact {

/// Factor x = c v0 of the force S(p) (1 + c p') of an impact that begins with the speed v0, by the formulas
/// of Hunt & Crossley (1975) 3 (1 - e) / 2, Lankarani & Nikravesh (1990) 3 (1 - e^2) / 4, Flores et al.
/// (2011) 8 (1 - e) / (5 e), or so that a free impact returns e. That one solves (1 + e) x = ln((1 + x) / (1
/// - e x)), the first integral of m p'' = -S(p) (1 + c p'), which is the same for every S.
double damping_factor(model::ImpactDamping damping, double restitution);

/// The e that a free impact with this factor returns, in (0, 1], by the same integral.
double restitution_of_factor(double factor);

/// Normal force of a contact that is no straight line: S(p) (1 + c p') where that does not pull, S(0) = 0, S
/// rising. Newtons and metres; for p < 0, where only a step that goes too far looks, S is odd.
class CurvedLaw {
 public:
  explicit CurvedLaw(const model::Stop& stop);

  double force_n(double penetration_m) const;
  double slope_n_per_m(double penetration_m) const;
  /// Integral of S from 0, for penetrations >= 0.
  double energy_j(double penetration_m) const;

  /// x = c v0.
  double factor() const { return factor_; }
  /// v0 of all impacts; empty: that of each one.
  const std::optional<double>& approach_m_per_s() const { return approach_m_per_s_; }
  /// Slowest approach that counts as itself, in clearances per radian of rotation: a graze would else be
  /// damped without bound.
  static constexpr double slowest_approach = 1e-3;

  bool remembers() const { return factor_ > 0 && !approach_m_per_s_; }

 private:
  double line_force_n(double penetration_m) const;

  model::NormalLaw law_;
  double factor_ = 0;
  std::optional<double> approach_m_per_s_;
  /// The line contact of Hertz has p = a F (b - ln F / 2) up to the force where it is as wide as long, beyond
  /// that its tangent; F = -2 q / W(-2 q e^{-2 b}), q = p / a, with the lower branch of Lambert's function.
  double a_ = 0, b_ = 0;
  numerics::Pchip table_;
  double end_m_ = 0, end_n_ = 0, end_slope_ = 0;  ///< start of the tangent to a line contact or table
  std::vector<double> energy_j_;                  ///< energies at the points of a table
};

/// Secant of a law that is not linear at a twentieth of the clearance, N/m: what estimates of a contact go
/// by.
double secant_n_per_m(const model::Stop& stop);

/// Mode of a contact with c = `damping`: open, sprung, or released where the force would pull.
constexpr Mode curved_mode(double damping, double penetration, double closing_speed) {
  if (penetration <= 0) return Mode::open;
  return 1 + damping * closing_speed <= 0 ? Mode::released : Mode::sprung;
}

/// Its guards, as guards_of has them.
constexpr Guards curved_guards(Mode mode, double damping, const Kinematics& k) {
  if (mode == Mode::open) return {{{{k.penetration, k.closing_speed, Mode::sprung}, {}}}, 1};
  const Guard opens{-k.penetration, -k.closing_speed, Mode::open};
  const double sign = mode == Mode::released ? 1 : -1;
  const Guard pulls{sign * (1 + damping * k.closing_speed), sign * damping * k.closing_acceleration,
                    mode == Mode::released ? Mode::sprung : Mode::released};
  return {{opens, pulls}, damping > 0 ? 2 : 1};
}

}  // namespace rubsweep::contact
