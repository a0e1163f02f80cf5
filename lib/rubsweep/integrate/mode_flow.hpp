#pragma once

#include <algorithm>
#include <span>

#include "rubsweep/integrate/exponential_series.hpp"
#include "rubsweep/integrate/mode_plan.hpp"
#include "rubsweep/integrate/step_table.hpp"

namespace rubsweep::integrate {

/// Moves every pair of z, a state or a disturbance of one, by its flow.
template <class Pairs, class Column>
void move_pairs(const Pairs& flow, Column&& z) {
  constexpr int N = Pairs::RowsAtCompileTime;
  const Eigen::Index n = flow.rows();
  const typename ExactTypes<N>::Part u = z.template head<N>(n).array(),
                                     v = z.template segment<N>(n, n).array();
  z.template head<N>(n) = (flow.col(0) * u + flow.col(1) * v).matrix();
  z.template segment<N>(n, n) = (flow.col(2) * u + flow.col(3) * v).matrix();
}

/// Flow of a mode of pairs over any duration, in closed form.
template <int N>
typename ExactTypes<N>::Pairs flow_of_pairs(const ModePlan<N>& mode, double duration_s);

/// Moves the free vibration by the series of its flow, |duration| up to longest_series over the mode's
/// fastest rate.
template <int N>
void move_by_series(const ModePlan<N>& mode, double duration_s, typename ExactTypes<N>::State& z);

/// Calls `step(k)` for steps of the mode's table as far as they fit into `duration_s` and pay: until the rest
/// is short for whatever goes at `fastest_rad_per_s`. Returns the rest.
template <int N, class Step>
double table_steps(const ModePlan<N>& mode, double fastest_rad_per_s, double duration_s, const Step& step) {
  while (duration_s > short_series / fastest_rad_per_s) {
    const int k = exact_step_below(duration_s * mode.longest_steps_per_s);
    if (k == exact_step_count) break;
    step(k);
    duration_s -= mode.longest_step_s * exact_step_size(k);
  }
  return duration_s;
}

/// An even number of Taylor coefficients of an exit but for its forced part, time in units of
/// 1 / fastest_rad_per_s.
template <int N>
void expand_exit(const ExitPlan<N>& exit, const typename ExactTypes<N>::State& z, std::span<double> terms) {
  std::fill(terms.begin(), terms.end(), 0.0);
  terms[0] = exit.constant;
  const auto column = [&](std::size_t i) {
    const Eigen::Index j = exit.columns[i];
    return SeriesColumn{exit.taylor.col(j).data(), z(j)};
  };
  std::size_t i = 0;
  for (; i + 4 <= exit.columns.size(); i += 4)
    add_terms(terms, column(i), column(i + 1), column(i + 2), column(i + 3));
  for (; i < exit.columns.size(); ++i) add_terms(terms, column(i));
}

extern template ExactTypes<2>::Pairs flow_of_pairs<2>(const ModePlan<2>&, double);
extern template void move_by_series<2>(const ModePlan<2>&, double, ExactTypes<2>::State&);
extern template ExactTypes<4>::Pairs flow_of_pairs<4>(const ModePlan<4>&, double);
extern template void move_by_series<4>(const ModePlan<4>&, double, ExactTypes<4>::State&);
extern template ExactTypes<6>::Pairs flow_of_pairs<6>(const ModePlan<6>&, double);
extern template void move_by_series<6>(const ModePlan<6>&, double, ExactTypes<6>::State&);
extern template ExactTypes<Eigen::Dynamic>::Pairs flow_of_pairs<Eigen::Dynamic>(
    const ModePlan<Eigen::Dynamic>&, double);
extern template void move_by_series<Eigen::Dynamic>(const ModePlan<Eigen::Dynamic>&, double,
                                                    ExactTypes<Eigen::Dynamic>::State&);

}  // namespace rubsweep::integrate
