#include "rubsweep/measurement/diagnose/inference/quantity.hpp"

#include <cmath>
#include <numbers>

#include "rubsweep/core/error.hpp"

namespace rubsweep::diagnose::inference {
namespace {

using std::numbers::pi;

constexpr std::array<std::string_view, all_quantities.size()> names{
    "clearance_m",  "stop_angle_deg",       "position_m",  "contact_fraction",
    "peak_force_n", "eccentricity_m",       "whirl_ratio", "stiffness_n_per_m",
    "restitution",  "friction_coefficient", "exponent"};

double value_in_case(const DiagnosisProblem& problem, const SimulatedCase& one, const ObservedCases& observed,
                     Eigen::Index row, const features::DescribedMotion& seen, Quantity quantity) {
  const double scale = seen.size_m / observed.size_m(row);
  const Point values = values_at(problem.candidates[one.candidate], one.unit);
  switch (quantity) {
    case Quantity::clearance: return simulated_clearance_m(problem.candidates[one.candidate]) * scale;
    case Quantity::stop_angle:
      if (problem.measuring.directions) return wrapped_deg(value_of(values, Unknown::stop_angle));
      return problem.measuring.probes == 2
                 ? wrapped_deg((seen.direction_rad - observed.direction_rad(row)) * 180 / pi)
                 : wrapped_deg(-observed.probe_angle_rad(row) * 180 / pi);
    case Quantity::position:
      return problem.fixed.kit ? place_of_stop(*problem.fixed.kit, value_of(values, Unknown::position)) : 0;
    case Quantity::contact_fraction: return one.motion.contact.contact_fraction;
    case Quantity::peak_force: return one.motion.contact.peak_contact_force_n * scale;
    case Quantity::eccentricity: return one.motion.eccentricity_m * scale;
    case Quantity::whirl_ratio: return value_of(values, Unknown::whirl_ratio);
    case Quantity::stiffness: return value_of(values, Unknown::stiffness);
    case Quantity::restitution: return value_of(values, Unknown::restitution);
    case Quantity::friction: return value_of(values, Unknown::friction);
    case Quantity::exponent: return value_of(values, Unknown::exponent);
  }
  throw SolverError("quantity: no such enumerator");
}

}  // namespace

bool has_quantity(const DiagnosisProblem& problem, std::size_t candidate, Quantity quantity) {
  const Cause cause = problem.candidates[candidate].cause;
  if (cause == Cause::no_rub) return false;
  if (quantity == Quantity::exponent) {
    const Spread& exponents = spread_of(problem.candidates[candidate], Unknown::exponent);
    return exponents.low < exponents.high;
  }
  if (quantity == Quantity::stop_angle) return cause != Cause::annular;
  return quantity != Quantity::position || problem.fixed.kit;
}

double wrapped_deg(double angle_deg) { return std::remainder(angle_deg, 360.0); }

std::string_view to_string(Quantity quantity) { return names[static_cast<std::size_t>(quantity)]; }

Eigen::VectorXd values_in_cases(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                Quantity quantity) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(set.cases.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values(i) = value_in_case(problem, set.cases[static_cast<std::size_t>(i)], observed, i, seen, quantity);
  return values;
}

}  // namespace rubsweep::diagnose::inference
