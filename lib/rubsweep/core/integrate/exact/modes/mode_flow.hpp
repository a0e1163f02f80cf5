#pragma once

#include <algorithm>
#include <span>

#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"

namespace rubsweep::integrate::exact::modes {

/// Moves each pair of z (a state or a tangent vector) by its flow.
template <class Pairs, class Column>
void move_pairs(const Pairs& flow, Column&& z) {
  constexpr int N = Pairs::RowsAtCompileTime;
  const Eigen::Index n = flow.rows();
  if constexpr (N == Eigen::Dynamic) {  // without copies, which would not fit into registers
    double* const u = z.data();
    double* const v = u + n;
    const double *const uu = flow.data(), *const uv = uu + n, *const vu = uv + n, *const vv = vu + n;
    for (Eigen::Index j = 0; j < n; ++j) {
      const double a = u[j], b = v[j];
      u[j] = uu[j] * a + uv[j] * b;
      v[j] = vu[j] * a + vv[j] * b;
    }
  } else {
    const typename ExactTypes<N>::Part u = z.template head<N>(n).array(),
                                       v = z.template segment<N>(n, n).array();
    z.template head<N>(n) = (flow.col(0) * u + flow.col(1) * v).matrix();
    z.template segment<N>(n, n) = (flow.col(2) * u + flow.col(3) * v).matrix();
  }
}

/// Flow of a mode with pairs over any duration, in closed form.
template <int N>
typename ExactTypes<N>::Pairs flow_of_pairs(const LinearMode<N>& mode, double duration_s);

/// Moves the free vibration by the series of its flow; |duration| may be up to longest_series divided by the
/// mode's fastest rate.
template <int N>
void move_by_series(const LinearMode<N>& mode, double duration_s, typename ExactTypes<N>::State& z);

/// Calls `step(k)` for table steps as long as they fit into `duration_s` and save time: until the remaining
/// duration is short for a series at `fastest_rad_per_s`. Returns the remaining duration.
template <int N, class TakeStep>
double table_steps(const LinearMode<N>& mode, double fastest_rad_per_s, double duration_s,
                   const TakeStep& step) {
  while (duration_s > numerics::short_series / fastest_rad_per_s) {
    const int k = numerics::exact_step_below(duration_s * mode.longest_steps_per_s);
    if (k == numerics::exact_step_count) break;
    step(k);
    duration_s -= mode.longest_step_s * numerics::exact_step_size(k);
  }
  return duration_s;
}

/// Index of the table step of exactly `duration_s`; exact_step_count where there is none.
template <int N>
int table_step_of(const LinearMode<N>& mode, double duration_s) {
  if (!(duration_s > 0)) return numerics::exact_step_count;  // a landing may be slightly negative by rounding
  const int below = numerics::exact_step_below(duration_s * mode.longest_steps_per_s);
  for (const int k : {below, below - 1}) {  // the step above, in case the product was rounded
    if (k >= 0 && k < numerics::exact_step_count &&
        duration_s == mode.longest_step_s * numerics::exact_step_size(k))
      return k;
  }
  return numerics::exact_step_count;
}

/// An even number of Taylor coefficients of a guard without its forced part; time is in units of 1 /
/// fastest_rad_per_s.
template <int N>
void expand_guard(const LinearGuard<N>& guard, const typename ExactTypes<N>::State& z,
                  std::span<double> terms) {
  std::fill(terms.begin(), terms.end(), 0.0);
  terms[0] = guard.constant;
  const auto column = [&](std::size_t i) {
    const Eigen::Index j = guard.columns[i];
    return numerics::SeriesColumn{guard.taylor.col(j).data(), z(j)};
  };
  std::size_t i = 0;
  for (; i + 4 <= guard.columns.size(); i += 4)
    numerics::add_terms(terms, column(i), column(i + 1), column(i + 2), column(i + 3));
  for (; i < guard.columns.size(); ++i) numerics::add_terms(terms, column(i));
}

}  // namespace rubsweep::integrate::exact::modes
