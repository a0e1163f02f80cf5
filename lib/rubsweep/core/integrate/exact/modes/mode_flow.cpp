#include "rubsweep/core/integrate/exact/modes/mode_flow.hpp"

#include <cmath>

#include "rubsweep/core/numerics/matrix_flow.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

/// Moves the state by `terms` terms of its series; the full matrices give each term from the one before.
template <int N>
void add_terms(const LinearMode<N>& mode, double duration_s, int terms, typename ExactTypes<N>::State& z) {
  const Eigen::Index n = mode.rest.size();
  typename ExactTypes<N>::Vector u = z.template head<N>(n), v = z.template segment<N>(n, n), spring, damper;
  for (int k = 1; k <= terms; ++k) {
    const double factor = duration_s * numerics::reciprocals[static_cast<std::size_t>(k)];
    numerics::put_product(mode.stiffness, u, spring);
    numerics::put_product(mode.damping, v, damper);
    for (Eigen::Index j = 0; j < n; ++j) {
      u(j) = factor * v(j);
      v(j) = -factor * (spring(j) + damper(j));
      z(j) += u(j);
      z(n + j) += v(j);
    }
  }
}

}  // namespace

template <int N>
typename ExactTypes<N>::Pairs flow_of_pairs(const LinearMode<N>& mode, double duration_s) {
  typename ExactTypes<N>::Pairs flow(mode.pairs.rows(), 4);
  for (Eigen::Index j = 0; j < flow.rows(); ++j) {
    const auto g = mode.pairs.row(j);
    // Both directions of an isotropic body share one flow.
    if (j > 0 && (g == mode.pairs.row(j - 1)).all()) {
      flow.row(j) = flow.row(j - 1);
    } else {
      const numerics::Pair f = numerics::pair_flow({g(0), g(1), g(2), g(3)}, duration_s);
      flow.row(j) << f.uu, f.uv, f.vu, f.vv;
    }
  }
  return flow;
}

template <int N>
void move_by_series(const LinearMode<N>& mode, double duration_s, typename ExactTypes<N>::State& z) {
  using Part = typename ExactTypes<N>::Part;
  const int terms = numerics::series_terms(std::abs(duration_s) * mode.fastest_rad_per_s);
  if (!mode.paired) return add_terms(mode, duration_s, terms, z);
  const Eigen::Index n = mode.rest.size();
  const double x = duration_s * mode.fastest_rad_per_s;
  Part unit = mode.unit_terms.col(terms), generator = mode.generator_terms.col(terms);
  for (int k = terms; k-- > 0;) {
    unit = x * unit + mode.unit_terms.col(k);
    generator = x * generator + mode.generator_terms.col(k);
  }
  const Part u = z.template head<N>(n).array(), v = z.template segment<N>(n, n).array();
  const auto& g = mode.pairs;
  const Part rate_u = g.col(0) * u + g.col(1) * v, rate_v = g.col(2) * u + g.col(3) * v;
  z.template head<N>(n) = (unit * u + generator * rate_u).matrix();
  z.template segment<N>(n, n) = (unit * v + generator * rate_v).matrix();
}

template ExactTypes<2>::Pairs flow_of_pairs<2>(const LinearMode<2>&, double);
template void move_by_series<2>(const LinearMode<2>&, double, ExactTypes<2>::State&);
template ExactTypes<4>::Pairs flow_of_pairs<4>(const LinearMode<4>&, double);
template void move_by_series<4>(const LinearMode<4>&, double, ExactTypes<4>::State&);
template ExactTypes<6>::Pairs flow_of_pairs<6>(const LinearMode<6>&, double);
template void move_by_series<6>(const LinearMode<6>&, double, ExactTypes<6>::State&);
template ExactTypes<Eigen::Dynamic>::Pairs flow_of_pairs<Eigen::Dynamic>(const LinearMode<Eigen::Dynamic>&,
                                                                         double);
template void move_by_series<Eigen::Dynamic>(const LinearMode<Eigen::Dynamic>&, double,
                                             ExactTypes<Eigen::Dynamic>::State&);

}  // namespace rubsweep::integrate::exact::modes
