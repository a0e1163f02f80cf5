#pragma once

#include <functional>
#include <optional>

namespace rubsweep::scene {

/// Largest e >= 0 at which a convex excursion(e) = |bow + e unbalance| reaches `target_m`; empty where it
/// stays above it. `slope` > 0: excursion grows by no more than this per metre of e, and in the end by as
/// much; `bow_m`: excursion(0).
std::optional<double> eccentricity_reaching(double target_m, double bow_m, double slope,
                                            const std::function<double(double)>& excursion);

}  // namespace rubsweep::scene
