#pragma once

#include <Eigen/Core>
#include <type_traits>

namespace rubsweep::integrate::run {

/// Calls `start(std::integral_constant<int, N>{})`. N is the number of coordinates if it is a usual one (a
/// rotor with no, one or two moving casings), else Eigen::Dynamic. The specialised model is chosen here, once
/// per run.
template <class Start>
decltype(auto) with_coordinates(Eigen::Index coordinates, const Start& start) {
  switch (coordinates) {
    case 2: return start(std::integral_constant<int, 2>{});
    case 4: return start(std::integral_constant<int, 4>{});
    case 6: return start(std::integral_constant<int, 6>{});
    default: return start(std::integral_constant<int, Eigen::Dynamic>{});
  }
}

}  // namespace rubsweep::integrate::run
