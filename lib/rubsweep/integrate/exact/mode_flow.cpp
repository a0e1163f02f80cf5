#include "rubsweep/integrate/exact/mode_flow.hpp"

#include <cmath>

#include "rubsweep/numerics/exponential_series.hpp"
#include "rubsweep/numerics/pair_flow.hpp"

namespace rubsweep::integrate::exact {
namespace {

/// Terms of a series by full matrices.
template <int N>
class SeriesTerm {
 public:
  using Part = typename ExactTypes<N>::Part;

  SeriesTerm(const LinearMode<N>& mode, const Part& u, const Part& v) : mode_(mode), u_(u), v_(v) {}

  /// (u, v) becomes factor * its rate, and is added to the sums.
  void differentiate(double factor, Part& sum_u, Part& sum_v) {
    numerics::put_product(mode_.stiffness, u_, spring_);
    numerics::put_product(mode_.damping, v_, damper_);
    for (Eigen::Index j = 0; j < u_.size(); ++j) {
      u_(j) = factor * v_(j);
      v_(j) = -factor * (spring_(j) + damper_(j));
      sum_u(j) += u_(j);
      sum_v(j) += v_(j);
    }
  }

 private:
  const LinearMode<N>& mode_;
  Part u_, v_;
  typename ExactTypes<N>::Vector spring_, damper_;
};

}  // namespace

template <int N>
typename ExactTypes<N>::Pairs flow_of_pairs(const LinearMode<N>& mode, double duration_s) {
  typename ExactTypes<N>::Pairs flow(mode.pairs.rows(), 4);
  for (Eigen::Index j = 0; j < flow.rows(); ++j) {
    const auto g = mode.pairs.row(j);
    // The two directions of an isotropic body share one flow.
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
  const Eigen::Index n = mode.rest.size();
  Part u = z.template head<N>(n).array(), v = z.template segment<N>(n, n).array();
  if (mode.paired) {
    const double x = duration_s * mode.fastest_rad_per_s;
    Part unit = mode.unit_terms.col(terms), generator = mode.generator_terms.col(terms);
    for (int k = terms; k-- > 0;) {
      unit = x * unit + mode.unit_terms.col(k);
      generator = x * generator + mode.generator_terms.col(k);
    }
    const auto& g = mode.pairs;
    const Part rate_u = g.col(0) * u + g.col(1) * v, rate_v = g.col(2) * u + g.col(3) * v;
    z.template head<N>(n) = (unit * u + generator * rate_u).matrix();
    z.template segment<N>(n, n) = (unit * v + generator * rate_v).matrix();
  } else {
    Part sum_u = u, sum_v = v;
    SeriesTerm<N> term(mode, u, v);
    for (int k = 1; k <= terms; ++k)
      term.differentiate(duration_s * numerics::reciprocals[static_cast<std::size_t>(k)], sum_u, sum_v);
    z.template head<N>(n) = sum_u.matrix();
    z.template segment<N>(n, n) = sum_v.matrix();
  }
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

}  // namespace rubsweep::integrate::exact
