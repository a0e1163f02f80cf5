#include "rubsweep/core/contact/curved_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/lambert_w.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "rubsweep/core/contact/hertz_line.hpp"
#include "rubsweep/core/model/stop.hpp"

namespace rubsweep::contact {
namespace {

/// Function whose root is the damping factor of a restitution; positive below the root. At small factors,
/// where its terms cancel, its power series is used, divided by the square of the factor.
double excess(double restitution, double factor) {
  if (factor < 1e-2) {
    double sum = 0, x = 1, e = restitution * restitution, sign = 1;
    for (int k = 2; k < 10; ++k, x *= factor, e *= restitution, sign = -sign) sum += x / k * (sign - e);
    return sum;
  }
  return (1 + restitution) * factor - std::log1p(factor) + std::log1p(-restitution * factor);
}

template <class Function>
double root(const Function& function, double low, double high) {
  std::uintmax_t iterations = 400;
  const auto bracket = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
}

double delivering_factor(double e) {
  // Approximate root, from both logarithms expanded to third order. Half of it is surely below the true root.
  const double about = 1.5 * (1 - e) / (1 - e + e * e), highest = std::nextafter(1 / e, 0.0);
  const auto at = [e](double factor) { return excess(e, factor); };
  // The factor of a small restitution is 1 / e to the last digit.
  return at(highest) >= 0 || about / 2 >= highest ? highest : root(at, about / 2, highest);
}

/// Integral of a cubic over an interval by Simpson's rule, which is exact here.
double integral_of_cubic(const numerics::Pchip& curve, double from, double to) {
  return (to - from) / 6 * (curve(from) + 4 * curve((from + to) / 2) + curve(to));
}

}  // namespace

double damping_factor(model::ImpactDamping damping, double restitution) {
  const double e = restitution;
  if (e == 1) return 0;
  switch (damping) {
    case model::ImpactDamping::none: return 0;
    case model::ImpactDamping::hunt_crossley: return 1.5 * (1 - e);
    case model::ImpactDamping::lankarani_nikravesh: return 0.75 * (1 - e * e);
    case model::ImpactDamping::flores: return 1.6 * (1 - e) / e;
    case model::ImpactDamping::delivered: return delivering_factor(e);
  }
  return 0;
}

double restitution_of_factor(double factor) {
  if (factor == 0) return 1;
  const double highest = std::min(1.0, std::nextafter(1 / factor, 0.0));
  const auto at = [factor](double e) { return excess(e, factor); };
  return at(highest) >= 0 ? highest : root(at, 0.0, highest);
}

CurvedLaw::CurvedLaw(const model::Stop& stop)
    : law_(stop.law), factor_(damping_factor(law_.damping, law_.restitution)), table_({0}, {0}) {
  if (law_.kind == model::ForceCurve::hertz_line) {
    const double ratio = stop.hertz->length_m / (2 * hertz_half_width_m(*stop.hertz, 1));
    b_ = 2 * std::numbers::ln2 + 0.5 + std::log(ratio);
    a_ = hertz_approach_m(*stop.hertz, 1) / b_;
    end_n_ = ratio * ratio;
    end_m_ = hertz_approach_m(*stop.hertz, end_n_);
    end_slope_ = 1 / (a_ * (b_ - 0.5 - std::log(end_n_) / 2));
    knots_m_ = {end_m_};
  }
  if (law_.kind != model::ForceCurve::table) return;
  table_ = {law_.penetration_m, law_.force_n};
  end_m_ = law_.penetration_m.back();
  end_n_ = law_.force_n.back();
  end_slope_ = table_.slope(end_m_);
  knots_m_.assign(law_.penetration_m.begin() + 1, law_.penetration_m.end());
}

double CurvedLaw::line_force_n(double penetration_m) const {
  const double q = penetration_m / a_, place = -2 * q * std::exp(-2 * b_);
  constexpr double least = 1e-300;
  return place > -least ? 0 : -2 * q / boost::math::lambert_wm1(place);
}

static_assert(model::force_curves.values.size() == 4,
              "force_n, slope_n_per_m, energy_j and describe must know a further law");

double CurvedLaw::force_n(double penetration_m) const {
  const double p = std::abs(penetration_m);
  double force = 0;
  if (law_.kind == model::ForceCurve::power) {
    force = law_.stiffness_n_per_m_n * std::pow(p, law_.exponent);
  } else if (p >= end_m_) {
    force = end_n_ + end_slope_ * (p - end_m_);
  } else {
    force = law_.kind == model::ForceCurve::table ? table_(p) : line_force_n(p);
  }
  return std::copysign(force, penetration_m);
}

double CurvedLaw::slope_n_per_m(double penetration_m) const {
  const double p = std::abs(penetration_m);
  if (law_.kind == model::ForceCurve::power)
    return law_.stiffness_n_per_m_n * law_.exponent * std::pow(p, law_.exponent - 1);
  if (p >= end_m_) return end_slope_;
  if (law_.kind == model::ForceCurve::table) return table_.slope(p);
  const double force = line_force_n(p);
  return force > 0 ? 1 / (a_ * (b_ - 0.5 - std::log(force) / 2)) : 0;
}

double CurvedLaw::energy_j(double penetration_m) const {
  if (law_.kind == model::ForceCurve::power)
    return force_n(penetration_m) * penetration_m / (law_.exponent + 1);
  const double p = std::min(penetration_m, end_m_), beyond = penetration_m - p;
  const double more = beyond * (end_n_ + end_slope_ * beyond / 2);
  if (law_.kind == model::ForceCurve::table) {
    double energy_j = more, from = 0;
    for (std::size_t k = 0; from < p; ++k) {
      const double to = std::min(knots_m_[k], p);
      energy_j += integral_of_cubic(table_, from, to);
      from = to;
    }
    return energy_j;
  }
  const double force = force_n(p);
  // Energy = F p minus the integral of p over F.
  return force == 0 ? 0 : force * (p - a_ * force * (b_ / 2 - std::log(force) / 4 + 0.125)) + more;
}

std::string describe(const model::NormalLaw& law) {
  if (law.kind == model::ForceCurve::power)
    return fmt::format("{} N/m^{} p^{}", law.stiffness_n_per_m_n, law.exponent, law.exponent);
  if (law.kind == model::ForceCurve::hertz_line) return "line contact of Hertz as it is";
  return fmt::format("measured curve of {} points up to {} m, beyond that its tangent", law.force_n.size(),
                     law.penetration_m.back());
}

double secant_n_per_m(const model::Stop& stop) {
  const double penetration_m = stop.clearance_m / 20;
  return CurvedLaw(stop).force_n(penetration_m) / penetration_m;
}

}  // namespace rubsweep::contact
