#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// By how much the sequence of contact modes of an orbit of the branch stays as it is: the distance of every
/// approach, and the squared duration of every hit, of every flight and of every stretch that leads from one
/// mode back to it. Each is a smooth function along the branch, and zero at the graze at which a hit (or
/// another stretch) appears or is gone. Their slopes are differences along the tangent. Empty where the orbit
/// beside this one cannot be made, or where nothing is known of contacts.
std::vector<Margin> margins_of(const orbits::OrbitProblem& problem, const BranchPoint& point);

/// Where between two points of a branch, as a share of the `length` of the step, one of these functions comes
/// near to zero, as dip_of_cubic() has it. `cosine` > 0: of the angle between the tangents at both ends.
/// Margins belong together that are of one kind and nearest to each other in phase.
std::optional<double> share_of_dip(const std::vector<Margin>& from, const std::vector<Margin>& to,
                                   double period_rad, double length, double cosine);

}  // namespace rubsweep::branch::continuation
