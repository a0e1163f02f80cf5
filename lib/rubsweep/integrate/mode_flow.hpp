#pragma once

#include <span>

#include "rubsweep/integrate/mode_plan.hpp"

namespace rubsweep::integrate {

/// Moves every pair of z, a state or a column of a transition, by its flow (uu, uv, vu, vv per pair).
template <int N, class Column>
void move_pairs(const Eigen::Array<double, N, 4>& flow, Column&& z) {
  const Eigen::Index n = flow.rows();
  const Eigen::Array<double, N, 1> u = z.template head<N>(n).array(), v = z.template segment<N>(n, n).array();
  z.template head<N>(n) = (flow.col(0) * u + flow.col(1) * v).matrix();
  z.template segment<N>(n, n) = (flow.col(2) * u + flow.col(3) * v).matrix();
}

/// Flow of a mode of pairs over any duration, in closed form.
template <int N>
Eigen::Array<double, N, 4> flow_of_pairs(const ModePlan<N>& mode, double duration_s);

/// Moves the free vibration by the series of its flow, |duration| up to longest_series over the mode's
/// fastest rate.
template <int N>
void move_by_series(const ModePlan<N>& mode, double duration_s, typename ExactTypes<N>::State& z);

/// Taylor coefficients of an exit but for its forced part, two or more, time in units of `within_s`.
template <int N>
void expand_exit(const ModePlan<N>& mode, const ExitPlan<N>& exit, const typename ExactTypes<N>::State& z,
                 double within_s, std::span<double> terms);

extern template Eigen::Array<double, 2, 4> flow_of_pairs<2>(const ModePlan<2>&, double);
extern template void move_by_series<2>(const ModePlan<2>&, double, ExactTypes<2>::State&);
extern template void expand_exit<2>(const ModePlan<2>&, const ExitPlan<2>&, const ExactTypes<2>::State&,
                                    double, std::span<double>);
extern template Eigen::Array<double, 4, 4> flow_of_pairs<4>(const ModePlan<4>&, double);
extern template void move_by_series<4>(const ModePlan<4>&, double, ExactTypes<4>::State&);
extern template void expand_exit<4>(const ModePlan<4>&, const ExitPlan<4>&, const ExactTypes<4>::State&,
                                    double, std::span<double>);
extern template Eigen::Array<double, 6, 4> flow_of_pairs<6>(const ModePlan<6>&, double);
extern template void move_by_series<6>(const ModePlan<6>&, double, ExactTypes<6>::State&);
extern template void expand_exit<6>(const ModePlan<6>&, const ExitPlan<6>&, const ExactTypes<6>::State&,
                                    double, std::span<double>);
extern template Eigen::Array<double, Eigen::Dynamic, 4> flow_of_pairs<Eigen::Dynamic>(
    const ModePlan<Eigen::Dynamic>&, double);
extern template void move_by_series<Eigen::Dynamic>(const ModePlan<Eigen::Dynamic>&, double,
                                                    ExactTypes<Eigen::Dynamic>::State&);
extern template void expand_exit<Eigen::Dynamic>(const ModePlan<Eigen::Dynamic>&,
                                                 const ExitPlan<Eigen::Dynamic>&,
                                                 const ExactTypes<Eigen::Dynamic>::State&, double,
                                                 std::span<double>);

}  // namespace rubsweep::integrate
