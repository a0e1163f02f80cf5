#include "rubsweep/integrate/mode_flow.hpp"

#include <cmath>

#include "rubsweep/integrate/exponential_series.hpp"
#include "rubsweep/integrate/pair_flow.hpp"

namespace rubsweep::integrate {
namespace {

/// (u, v) becomes factor * its rate, by full matrices.
template <int N>
void differentiate(const ModePlan<N>& mode, double factor, Eigen::Array<double, N, 1>& u,
                   Eigen::Array<double, N, 1>& v) {
  typename ExactTypes<N>::Vector push = mode.stiffness.lazyProduct(u.matrix());
  push += mode.damping.lazyProduct(v.matrix());
  u = factor * v;
  v = -factor * push.array();
}

}  // namespace

template <int N>
Eigen::Array<double, N, 4> flow_of_pairs(const ModePlan<N>& mode, double duration_s) {
  Eigen::Array<double, N, 4> flow(mode.pairs.rows(), 4);
  for (Eigen::Index j = 0; j < flow.rows(); ++j) {
    const auto g = mode.pairs.row(j);
    // The two directions of an isotropic body share one flow.
    if (j > 0 && (g == mode.pairs.row(j - 1)).all()) {
      flow.row(j) = flow.row(j - 1);
    } else {
      const Pair f = pair_flow({g(0), g(1), g(2), g(3)}, duration_s);
      flow.row(j) << f.uu, f.uv, f.vu, f.vv;
    }
  }
  return flow;
}

template <int N>
void move_by_series(const ModePlan<N>& mode, double duration_s, typename ExactTypes<N>::State& z) {
  using Part = Eigen::Array<double, N, 1>;
  const int terms = series_terms(std::abs(duration_s) * mode.fastest_rad_per_s);
  const Eigen::Index n = mode.rest.size();
  Part u = z.template head<N>(n).array(), v = z.template segment<N>(n, n).array(), sum_u = u, sum_v = v;
  if (mode.paired) {
    const Eigen::Array<double, N, 4> step = duration_s * mode.pairs;
    for (int k = 1; k <= terms; ++k) {
      const double factor = reciprocals[static_cast<std::size_t>(k)];
      const Part next = factor * (step.col(0) * u + step.col(1) * v);
      v = factor * (step.col(2) * u + step.col(3) * v);
      u = next;
      sum_u += u;
      sum_v += v;
    }
  } else {
    for (int k = 1; k <= terms; ++k) {
      differentiate<N>(mode, duration_s * reciprocals[static_cast<std::size_t>(k)], u, v);
      sum_u += u;
      sum_v += v;
    }
  }
  z.template head<N>(n) = sum_u.matrix();
  z.template segment<N>(n, n) = sum_v.matrix();
}

/// A pair's part of an exit obeys y'' = trace y' - determinant y.
template <int N>
void expand_exit(const ModePlan<N>& mode, const ExitPlan<N>& exit, const typename ExactTypes<N>::State& z,
                 double within_s, std::span<double> terms) {
  using Part = Eigen::Array<double, N, 1>;
  const auto& both = exit.whole.row_and_rate;
  if (!mode.paired) {
    const Eigen::Index n = mode.rest.size();
    const typename ExactTypes<N>::Row row = both.row(0);
    Part u = z.template head<N>(n).array(), v = z.template segment<N>(n, n).array();
    for (std::size_t k = 0; k < terms.size(); ++k) {
      terms[k] = (row.template head<N>(n).transpose().array() * u +
                  row.template segment<N>(n, n).transpose().array() * v)
                     .sum();
      differentiate<N>(mode, within_s * reciprocals[k + 1], u, v);
    }
  } else {
    const Eigen::Index n = mode.rest.size();
    const auto parts = [&](Eigen::Index row) -> Part {
      return both.row(row).template head<N>(n).transpose().array() * z.template head<N>(n).array() +
             both.row(row).template segment<N>(n, n).transpose().array() *
                 z.template segment<N>(n, n).array();
    };
    const Part trace = within_s * mode.trace, determinant = within_s * within_s * mode.determinant;
    Part last = parts(0), now = within_s * parts(1);
    terms[0] = last.sum();
    terms[1] = now.sum();
    for (std::size_t k = 1; k + 1 < terms.size(); ++k) {
      const Part next =
          (reciprocals[k + 1] * trace) * now - (reciprocals[k] * reciprocals[k + 1] * determinant) * last;
      terms[k + 1] = next.sum();
      last = now;
      now = next;
    }
  }
  terms[0] += exit.constant;
}

template Eigen::Array<double, 2, 4> flow_of_pairs<2>(const ModePlan<2>&, double);
template void move_by_series<2>(const ModePlan<2>&, double, ExactTypes<2>::State&);
template void expand_exit<2>(const ModePlan<2>&, const ExitPlan<2>&, const ExactTypes<2>::State&, double,
                             std::span<double>);
template Eigen::Array<double, 4, 4> flow_of_pairs<4>(const ModePlan<4>&, double);
template void move_by_series<4>(const ModePlan<4>&, double, ExactTypes<4>::State&);
template void expand_exit<4>(const ModePlan<4>&, const ExitPlan<4>&, const ExactTypes<4>::State&, double,
                             std::span<double>);
template Eigen::Array<double, 6, 4> flow_of_pairs<6>(const ModePlan<6>&, double);
template void move_by_series<6>(const ModePlan<6>&, double, ExactTypes<6>::State&);
template void expand_exit<6>(const ModePlan<6>&, const ExitPlan<6>&, const ExactTypes<6>::State&, double,
                             std::span<double>);
template Eigen::Array<double, Eigen::Dynamic, 4> flow_of_pairs<Eigen::Dynamic>(
    const ModePlan<Eigen::Dynamic>&, double);
template void move_by_series<Eigen::Dynamic>(const ModePlan<Eigen::Dynamic>&, double,
                                             ExactTypes<Eigen::Dynamic>::State&);
template void expand_exit<Eigen::Dynamic>(const ModePlan<Eigen::Dynamic>&, const ExitPlan<Eigen::Dynamic>&,
                                          const ExactTypes<Eigen::Dynamic>::State&, double,
                                          std::span<double>);

}  // namespace rubsweep::integrate
