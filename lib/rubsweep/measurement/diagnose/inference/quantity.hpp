#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>

#include "rubsweep/measurement/diagnose/inference/posterior.hpp"

namespace rubsweep::diagnose::inference {

/// Parameters of the machine for which a diagnosis gives intervals.
enum class Quantity {
  clearance,         ///< clearance at the first stop, m
  stop_angle,        ///< direction of the first stop or of the offset, degrees from +x to +y
  position,          ///< place of the stops along the shaft of a rotor kit, m
  contact_fraction,  ///< share of time in contact
  peak_force,        ///< largest normal force, N
  eccentricity,      ///< eccentricity of the unbalance, m
  whirl_ratio,
  stiffness,  ///< stiffness of the contact, N/m
  restitution,
  friction,
  exponent  ///< exponent of the penetration in the contact force
};
inline constexpr std::array all_quantities{
    Quantity::clearance,   Quantity::stop_angle,   Quantity::position,    Quantity::contact_fraction,
    Quantity::peak_force,  Quantity::eccentricity, Quantity::whirl_ratio, Quantity::stiffness,
    Quantity::restitution, Quantity::friction,     Quantity::exponent};

std::string_view to_string(Quantity quantity);  ///< Name with unit, such as clearance_m or stop_angle_deg.

/// Whether a candidate has this quantity. Without a rub there are no quantities; a round stop about the rest
/// position has no direction; a Jeffcott rotor has no positions along the shaft; an exponent may be known.
bool has_quantity(const DiagnosisProblem& problem, std::size_t candidate, Quantity quantity);

double wrapped_deg(double angle_deg);  ///< Equivalent angle in [-180, 180].

/// Value of the quantity in every case, after the case was scaled and rotated to the recording. With two
/// probes, or on an anisotropic machine, stop angles are measured from +x, in [-180, 180]. Otherwise they are
/// measured from the direction of the single probe.
Eigen::VectorXd values_in_cases(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                Quantity quantity);

}  // namespace rubsweep::diagnose::inference
