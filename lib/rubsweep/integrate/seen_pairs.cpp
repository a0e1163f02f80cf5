#include "rubsweep/integrate/seen_pairs.hpp"

namespace rubsweep::integrate {

SeenPairs seen_pairs(const Eigen::Matrix<double, 4, Eigen::Dynamic>& rows, const std::vector<bool>& fast) {
  const Eigen::Index n = rows.cols() / 2;
  SeenPairs seen;
  for (const bool wanted : {false, true}) {
    for (Eigen::Index u = 0; u < n; ++u) {
      const Eigen::Index v = n + u;
      if (fast[static_cast<std::size_t>(u)] != wanted) continue;
      if (rows.col(u).isZero(0) && rows.col(v).isZero(0)) continue;
      seen.list.push_back({.u = u,
                           .v = v,
                           .value_u = rows(0, u),
                           .value_v = rows(0, v),
                           .rate_u = rows(1, u),
                           .rate_v = rows(1, v),
                           .bound_u = rows(2, u),
                           .bound_v = rows(2, v),
                           .envelope = rows(3, u)});
      if (!wanted) ++seen.slow_count;
    }
  }
  if (seen.list.empty()) seen.list.push_back({.u = 0, .v = n});
  return seen;
}

}  // namespace rubsweep::integrate
