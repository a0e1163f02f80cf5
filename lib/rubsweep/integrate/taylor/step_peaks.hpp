#pragma once

#include <vector>

#include "rubsweep/integrate/run/scaled_system.hpp"
#include "rubsweep/integrate/taylor/contact_series.hpp"
#include "rubsweep/integrate/taylor/expansion.hpp"

namespace rubsweep::integrate::taylor {

/// Largest distances from where a point is unloaded, scaled.
struct LargestDisplacements {
  double observed = 0;  ///< of the observed point
  double casing = 0;    ///< of any casing
};

/// Over the first `duration_rad` of an expanded motion. `fastest` is the fastest rate of the motion per
/// radian; `probe` and `other` have room for a state.
template <int N>
LargestDisplacements largest_displacements(const Expansion<N>& motion, const run::ScaledSystem<N>& system,
                                           double fastest, double duration_rad, std::vector<double>& probe,
                                           std::vector<double>& other);

/// Largest normal force of a touching contact over the same, newtons.
double largest_force(const ContactSeries& contact, int order, double fastest, double duration_rad);

extern template LargestDisplacements largest_displacements<2>(const Expansion<2>&,
                                                              const run::ScaledSystem<2>&, double, double,
                                                              std::vector<double>&, std::vector<double>&);
extern template LargestDisplacements largest_displacements<4>(const Expansion<4>&,
                                                              const run::ScaledSystem<4>&, double, double,
                                                              std::vector<double>&, std::vector<double>&);
extern template LargestDisplacements largest_displacements<6>(const Expansion<6>&,
                                                              const run::ScaledSystem<6>&, double, double,
                                                              std::vector<double>&, std::vector<double>&);
extern template LargestDisplacements largest_displacements<Eigen::Dynamic>(
    const Expansion<Eigen::Dynamic>&, const run::ScaledSystem<Eigen::Dynamic>&, double, double,
    std::vector<double>&, std::vector<double>&);

}  // namespace rubsweep::integrate::taylor
