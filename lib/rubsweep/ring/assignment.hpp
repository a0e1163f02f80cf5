#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubsweep::ring {

/// Column of every row so that the sum of `cost` (square, finite) is smallest: the Hungarian method, O(n^3).
std::vector<Eigen::Index> cheapest_assignment(const Eigen::MatrixXd& cost);

}  // namespace rubsweep::ring
