#include "rubsweep/core/integrate/taylor/guard_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "rubsweep/core/integrate/taylor/series_options.hpp"
#include "rubsweep/core/numerics/polynomial_root.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Mode;
using Coefficients = std::array<double, numerics::most_taylor_order + 1>;

/// Distance from zero, in clearances, below which a falling guard counts as starting at zero. It is 1e-13 for
/// series that end at rounding, because a landing leaves a few units of rounding in states of order one.
double noise_of(double accuracy) { return 1e-13 / rounding_of_series * accuracy; }

/// Value that represents "just below zero": smaller than any guard that changes.
constexpr double just_below_zero = -1e-30;

/// First rise of an armed guard, which counts as below zero at the start of the piece. If the guard is at
/// zero there (or slightly beyond by rounding) and still rising, its root is at the start. The previous
/// piece, which ends at this instant, was not searched there. If its rate is zero as well, it is set just
/// below zero. Its first non-zero derivative then decides, as where a rotor starts at rest at a wall.
std::optional<double> first_rise_of_armed(std::span<double> c, double noise) {
  if (c[0] >= 0 && c.size() > 1) {
    if (c[1] > 0) return 0;
    if (c[1] == 0) c[0] = just_below_zero;
  }
  return numerics::first_rise_of(c, noise);
}

/// Factors 1, 2, ... of the coefficients in a derivative.
constexpr auto rate_factors = [] {
  Coefficients factors{};
  for (std::size_t k = 0; k < factors.size(); ++k) factors[k] = static_cast<double>(k + 1);
  return factors;
}();

std::span<double> first(Coefficients& c, int count) {
  return std::span(c).first(static_cast<std::size_t>(count));
}

/// Sums of |a_k| t^k over the first `count` terms of both components: their bounds up to t.
numerics::Twin bounds_of(const numerics::PlaneSeries& a, int count, double t) {
  using numerics::Twin;
  Twin sums{}, power{1, 1};
  const Twin step = numerics::both(t);
  for (int k = 0; k < count; ++k, power *= step) sums += numerics::magnitudes(a[k]) * power;
  return sums;
}

/// Bound of |d'| over the duration, which is also a bound of the sliding speed.
double fastest_distance(const ContactSeries& contact, int order, double duration_rad) {
  const numerics::Twin bounds = bounds_of(contact.velocity(), order, duration_rad);
  return contact.law().annular ? std::sqrt(bounds[0] * bounds[0] + bounds[1] * bounds[1]) : bounds[1];
}

/// Zero of the slip, approached from its present side. The slip is measured in clearances per radian. It
/// counts as starting at zero if it is within rounding of the surface's own speed.
std::optional<double> first_stop(ContactSeries& contact, int order, double accuracy, double duration_rad,
                                 const SlipStart& start) {
  const ContactLaw& law = contact.law();
  const double surface = law.surface_speed_m_per_s / law.slip_scale_m_per_s, sign = -contact.slip_sign();
  if (-sign * surface - fastest_distance(contact, order, duration_rad) > 0) return std::nullopt;
  contact.make_sliding(order);
  Coefficients c{};
  double power = 1;
  for (int k = 0; k < order; ++k, power *= duration_rad)
    c[static_cast<std::size_t>(k)] = power * sign * (contact.sliding()[k] + (k == 0 ? surface : 0));
  const double unit = std::max(1.0, std::abs(surface));
  if (start.poised_within > 0) c[0] = std::min(c[0], -start.poised_within * unit);
  const double noise = noise_of(accuracy) * unit;
  if (start.zero_terms == 0) return first_rise_of_armed(first(c, order), noise);
  return numerics::first_rise_of(first(c, order).subspan(static_cast<std::size_t>(start.zero_terms)), noise);
}

/// Zero of the margin between the holding friction and `sign` times its limit, in units of the stop's spring
/// force at one clearance.
std::optional<double> first_release(const ContactSeries& contact, int order, double duration_rad,
                                    double sign) {
  const double unit = contact.law().stiffness * contact.law().clearance;
  Coefficients c{};
  double power = 1;
  for (int k = 0; k < order; ++k, power *= duration_rad)
    c[static_cast<std::size_t>(k)] = -power * contact.reserve_term(k, sign) / unit;
  return first_rise_of_armed(first(c, order), 0);
}

/// The first `order` coefficients of `sign` slip + `constant`, with time in units of the duration.
Coefficients slip_polynomial(ContactSeries& contact, int order, double duration_rad, double sign,
                             double constant) {
  contact.make_sliding(order);
  Coefficients c{};
  double power = 1;
  for (int k = 0; k < order; ++k, power *= duration_rad)
    c[static_cast<std::size_t>(k)] = power * sign * contact.slip_term(k) + (k == 0 ? constant : 0);
  return c;
}

/// Whether |d| surely stays inside an annular stop: a cheaper test than the polynomial of its square.
bool far_from_wall(const ContactSeries& contact, int order, double duration_rad) {
  const numerics::Twin bounds = bounds_of(contact.distance(), order + 1, duration_rad);
  const double clearance = contact.law().clearance;
  return bounds[0] * bounds[0] + bounds[1] * bounds[1] < clearance * clearance;
}

}  // namespace

double guards_converged_rad(ContactSeries& contact, int order, double accuracy, double duration_rad) {
  const ContactLaw& law = contact.law();
  const double last_terms = accuracy / 2;
  if (contact.sticks() && !contact.creep()) {
    const double unit =
        std::max(law.friction.holding * law.stiffness * law.clearance, std::abs(contact.holding().number(0)));
    for (int k = order - 2; k < order; ++k) {
      const double term = std::abs(contact.holding().number(k)) / unit;
      duration_rad = numerics::longest_below(duration_rad, term, k, last_terms);
    }
  }
  // Guards of flat stops are linear in the motion.
  if (!law.annular) return duration_rad;
  if (contact.mode() == Mode::open) {
    if (far_from_wall(contact, order, duration_rad)) return duration_rad;
    contact.make_open_penetration(order);
  }
  const double damper = law.damping / law.stiffness;
  // Far inside the wall, the rounding error is proportional to the penetration.
  const double size = std::max(law.clearance, std::abs(contact.penetration_term(0)));
  for (int k = order - 2; k < order; ++k) {
    const double term = (std::abs(contact.penetration_term(k)) +
                         damper * (k + 1) * std::abs(contact.penetration_term(k + 1))) /
                        size;
    duration_rad = numerics::longest_below(duration_rad, term, k, last_terms);
  }
  return duration_rad;
}

std::optional<GuardCrossing> first_guard(const ContactSeries& contact, int order, double accuracy,
                                         double duration_rad) {
  const ContactLaw& law = contact.law();
  const Mode mode = contact.mode();
  if (mode == Mode::open && law.annular && far_from_wall(contact, order, duration_rad)) return std::nullopt;
  // Coefficients of penetration and closing speed; those of rates end one order earlier.
  Coefficients all, power, p, v;
  contact.put_penetration(order, all.data());
  numerics::put_powers(duration_rad, order, power.data());
  const auto count = static_cast<std::size_t>(order);
  // The position of a distant wall has its own rounding error.
  const double noise = noise_of(accuracy) * std::max(1.0, law.clearance);
  for (std::size_t k = 0; k < count; ++k) {
    p[k] = power[k] * all[k];
    v[k] = power[k] * rate_factors[k] * all[k + 1];
  }
  const contact::GuardForms forms = contact::guard_forms(mode, law.damping > 0);
  std::optional<GuardCrossing> earliest;
  for (std::size_t e = 0; e < static_cast<std::size_t>(forms.count); ++e) {
    const auto& [spring, damper, to] = forms.list[e];
    Coefficients guard;
    const double by_v = damper * law.damping / law.stiffness;
    for (std::size_t k = 0; k < count; ++k) guard[k] = spring * p[k] + by_v * v[k];
    const auto rise = first_rise_of_armed(first(guard, order), noise);
    if (rise && (!earliest || *rise < earliest->share)) earliest = GuardCrossing{*rise, to};
  }
  return earliest;
}

std::optional<double> first_rise(std::span<double> coefficients, double accuracy) {
  return first_rise_of_armed(coefficients, noise_of(accuracy));
}

std::optional<SlipEvent> first_slip_event(ContactSeries& contact, int order, double accuracy,
                                          double duration_rad, const SlipStart& start) {
  using contact::Slip;
  if (!contact.sticks()) {
    const auto stop = first_stop(contact, order, accuracy, duration_rad, start);
    return stop ? std::optional(SlipEvent{*stop, Slip::sticking}) : std::nullopt;
  }
  std::optional<SlipEvent> first;
  for (const Slip slip : {Slip::forward, Slip::backward}) {
    const auto release = first_release(contact, order, duration_rad, contact::sign_of(slip));
    if (release && (!first || *release < first->share)) first = SlipEvent{*release, slip};
  }
  return first;
}

double reserve_rate(const ContactSeries& contact, int order, double duration_rad, contact::Slip slip) {
  double rate = 0;
  for (int k = order - 1; k > 0; --k)
    rate = rate * duration_rad + k * contact.reserve_term(k, contact::sign_of(slip));
  return rate;
}

double saturated_share(ContactSeries& contact, int order, double duration_rad) {
  const double steepness = contact.saturated_steepness();
  if (steepness == 0) return 1;
  const ContactLaw& law = contact.law();
  const double least = saturated_until / steepness, sign = contact.slip_sign();
  const double reach = law.slip_scale_m_per_s * fastest_distance(contact, order, duration_rad);
  if (sign * law.surface_speed_m_per_s - reach > least) return 1;
  Coefficients c = slip_polynomial(contact, order, duration_rad, -sign, least);
  return numerics::first_rise_of(first(c, order), 0).value_or(1);
}

bool slip_reverses(ContactSeries& contact, int order, double duration_rad) {
  const ContactLaw& law = contact.law();
  const double reach = law.slip_scale_m_per_s * fastest_distance(contact, order, duration_rad);
  if (law.surface_speed_m_per_s - reach > 0) return false;
  Coefficients c = slip_polynomial(contact, order, duration_rad, -1, 0);
  return c[0] >= 0 || numerics::first_rise_of(first(c, order), 0).has_value();
}

}  // namespace rubsweep::integrate::taylor
