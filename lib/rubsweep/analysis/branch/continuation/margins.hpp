#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// The functions whose roots are events, at these multipliers.
MultiplierTests tests_of_multipliers(const Eigen::VectorXcd& multipliers);

/// How they change along the branch, per unit of its length: a difference along the tangent, on which the
/// neighbouring orbits lie but for terms of second order, so that none of them need be found. Zero where the
/// map cannot be made there.
MultiplierTests multiplier_slopes(const orbits::OrbitProblem& problem, const BranchPoint& point);

/// A smooth function at both ends of a step: its values, and its slopes per unit of the step's length.
struct StepEnds {
  double begin = 0, end = 0;
  double begin_slope = 0, end_slope = 0;
};

/// Where between the ends, as a share of the step, a function should be looked at because it may have two
/// roots more than its signs at the ends tell: the cubic through `ends` comes as near to zero there as
/// half of the nearer end, or beyond it. Empty where it does not. `length` > 0: of the step.
std::optional<double> dip_of_cubic(const StepEnds& ends, double length);

/// The same share for a function with these values at the ends and this mean in between, by a quadratic.
std::optional<double> dip_of_quadratic(double begin, double end, double mean);

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
