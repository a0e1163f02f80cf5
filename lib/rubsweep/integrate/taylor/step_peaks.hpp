#pragma once

#include <vector>

#include "rubsweep/integrate/run/scaled_system.hpp"
#include "rubsweep/integrate/taylor/contact_series.hpp"
#include "rubsweep/integrate/taylor/expansion.hpp"

namespace rubsweep::integrate::taylor {

/// Largest distance of the observed point from its origin over the first `duration_rad` of an expanded
/// motion, scaled. `fastest` is the fastest rate of the motion per radian; `probe` has room for a state.
template <int N>
double largest_displacement(const Expansion<N>& motion, const run::ScaledSystem<N>& system, double fastest,
                            double duration_rad, std::vector<double>& probe);

/// Largest normal force of a touching contact over the same, newtons.
double largest_force(const ContactSeries& contact, int order, double fastest, double duration_rad);

extern template double largest_displacement<2>(const Expansion<2>&, const run::ScaledSystem<2>&, double,
                                               double, std::vector<double>&);
extern template double largest_displacement<4>(const Expansion<4>&, const run::ScaledSystem<4>&, double,
                                               double, std::vector<double>&);
extern template double largest_displacement<6>(const Expansion<6>&, const run::ScaledSystem<6>&, double,
                                               double, std::vector<double>&);
extern template double largest_displacement<Eigen::Dynamic>(const Expansion<Eigen::Dynamic>&,
                                                            const run::ScaledSystem<Eigen::Dynamic>&, double,
                                                            double, std::vector<double>&);

}  // namespace rubsweep::integrate::taylor
