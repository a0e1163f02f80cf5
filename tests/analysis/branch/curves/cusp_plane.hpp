#pragma once

#include <optional>

#include "analysis/branch/curves/plain_planes.hpp"
#include "rubsweep/analysis/branch/curves/curve.hpp"

namespace rubsweep::test {

/// x -> x + p + q x - x^3 has folds on 27 p^2 = 4 q^3, which meet in a cusp at (0, 0).
inline branch::orbits::PlaneOrbits cusp_plane() {
  return plain_plane_of_one_number([](double p, double q, double x) { return x + p + q * x - x * x * x; },
                                   [](double, double q, double x) { return 1 + q - 3 * x * x; });
}

/// Its folds by the state r: p = -2 r^3, q = 3 r^2.
struct FoldsOfACusp {
  branch::orbits::PlaneOrbits orbits = cusp_plane();
  branch::curves::ExtendedSystem system{&orbits, branch::continuation::EventKind::fold, 1};

  FoldsOfACusp() = default;
  FoldsOfACusp(const FoldsOfACusp&) = delete;
  FoldsOfACusp& operator=(const FoldsOfACusp&) = delete;

  branch::continuation::Position at(double r) const {
    return position_of(system, {-2 * r * r * r, 3 * r * r, 0}, Eigen::VectorXd::Constant(1, r));
  }

  /// Point at r; its tangent points towards increasing r.
  std::optional<branch::curves::CurvePoint> point(double r) const {
    branch::continuation::Position direction = branch::continuation::Position::Zero(3);
    direction(0) = 1;
    const branch::curves::CurveCorrection found = correct(system, at(r), direction);
    return found.converged ? completed(system, found, direction, r) : std::nullopt;
  }
};

}  // namespace rubsweep::test
