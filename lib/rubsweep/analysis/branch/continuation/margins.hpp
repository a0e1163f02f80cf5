#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// Test functions of the events, computed from these multipliers.
MultiplierTests tests_of_multipliers(const Eigen::VectorXcd& multipliers);

/// Slopes of the test functions per unit of arclength, by a difference along the tangent. Points on the
/// tangent agree with the neighbouring orbits up to terms of second order, so that these orbits need not be
/// computed. Zero where the map cannot be evaluated there.
MultiplierTests multiplier_slopes(const orbits::OrbitProblem& problem, const BranchPoint& point);

/// Values and slopes of a smooth function at both ends of a step. Slopes are per unit of length.
struct StepEnds {
  double begin = 0, end = 0;
  double begin_slope = 0, end_slope = 0;
};

/// Place in the step, as a share of its `length` > 0, at which a function may have two more roots than its
/// signs at the ends show. If the function is positive at the begin, the place is the local minimum of the
/// cubic through `ends`. Empty unless the value there is below half the value at the end nearer to zero.
std::optional<double> dip_of_cubic(const StepEnds& ends, double length);

/// The same place as in dip_of_cubic(), for a function of which only the values at the ends and the mean over
/// the step are known. Uses a quadratic.
std::optional<double> dip_of_quadratic(double begin, double end, double mean);

/// Margins of an orbit against a change of its sequence of contact modes: the distance of every approach, and
/// the squared duration of every hit, every flight, and every stretch that returns to its mode. Each margin
/// is smooth along the branch, and zero at the graze where the hit or stretch appears or disappears. Slopes
/// are differences along the tangent. Empty where a neighbouring orbit cannot be computed, or where contacts
/// are unknown.
std::vector<Margin> margins_of(const orbits::OrbitProblem& problem, const BranchPoint& point);

/// Place between two points of a branch, as a share of the step's `length`, at which one of these margins
/// comes near zero, as defined in dip_of_cubic(). `cosine` > 0: cosine of the angle between the tangents at
/// both ends. Margins of the two points correspond if they have the same kind and are nearest in phase.
std::optional<double> share_of_dip(const std::vector<Margin>& from, const std::vector<Margin>& to,
                                   double period_rad, double length, double cosine);

}  // namespace rubsweep::branch::continuation
