#include "rubsweep/core/integrate/exact/modes/modal_terms.hpp"

namespace rubsweep::integrate::exact::modes {

ModalTerms modal_terms(const Eigen::Matrix<double, 4, Eigen::Dynamic>& rows, const std::vector<bool>& fast) {
  const Eigen::Index n = rows.cols() / 2;
  ModalTerms terms;
  for (const bool wanted : {false, true}) {
    for (Eigen::Index u = 0; u < n; ++u) {
      const Eigen::Index v = n + u;
      if (fast[static_cast<std::size_t>(u)] != wanted) continue;
      if (rows.col(u).isZero(0) && rows.col(v).isZero(0)) continue;
      terms.list.push_back({.u = u,
                            .v = v,
                            .value = numerics::Twin{rows(0, u), rows(0, v)},
                            .rate = numerics::Twin{rows(1, u), rows(1, v)},
                            .bound = numerics::Twin{rows(2, u), rows(2, v)},
                            .envelope = rows(3, u)});
      if (!wanted) ++terms.slow_count;
    }
  }
  if (terms.list.empty()) terms.list.push_back({.u = 0, .v = n});
  return terms;
}

}  // namespace rubsweep::integrate::exact::modes
