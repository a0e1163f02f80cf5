#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>

#include "rubsweep/measurement/diagnose/inference/posterior.hpp"

namespace rubsweep::diagnose::inference {

/// Numbers of a machine that a diagnosis answers with.
enum class Quantity {
  clearance,         ///< clearance at the first stop, m
  stop_angle,        ///< direction of the first stop, or of an offset, degrees from +x to +y
  position,          ///< place of the stops along the shaft of a rotor kit, m
  contact_fraction,  ///< share of time in contact
  peak_force,        ///< largest normal force, N
  eccentricity,      ///< unbalance, m
  whirl_ratio,
  stiffness,  ///< N/m
  restitution,
  friction
};
inline constexpr std::array all_quantities{
    Quantity::clearance,   Quantity::stop_angle,   Quantity::position,    Quantity::contact_fraction,
    Quantity::peak_force,  Quantity::eccentricity, Quantity::whirl_ratio, Quantity::stiffness,
    Quantity::restitution, Quantity::friction};

/// Name with its unit: clearance_m, stop_angle_deg.
std::string_view to_string(Quantity quantity);

/// Whether a candidate has such a number: no rub has none, a round stop about the rest position stands in no
/// direction, and a Jeffcott rotor has no places.
bool has_quantity(const DiagnosisProblem& problem, std::size_t candidate, Quantity quantity);

/// The same angle in [-180, 180].
double wrapped_deg(double angle_deg);

/// Value in every case, scaled and turned to the recording. Stop angles: of two probes, or of a machine that
/// is not the same in all directions, from +x, in [-180, 180]; else from the direction in which the one probe
/// looks.
Eigen::VectorXd values_in_cases(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                Quantity quantity);

}  // namespace rubsweep::diagnose::inference
