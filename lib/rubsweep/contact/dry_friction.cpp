#include "rubsweep/contact/dry_friction.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace rubsweep::contact {
namespace {

/// One surface after the other takes the friction that suits it while the others keep theirs (Gauss-Seidel):
/// of a single one that is the answer, and of several it converges because the mobility has no negative
/// eigenvalue.
constexpr int most_sweeps = 2000;
constexpr double settled = 1e-15;
constexpr double independent = 1e-10;  ///< share of the largest mobility

}  // namespace

bool determined(const StickMobility& mobility) {
  auto decomposition = mobility.completeOrthogonalDecomposition();
  decomposition.setThreshold(independent);
  return decomposition.rank() == mobility.rows();
}

StickVector holding_forces(const StickMobility& mobility, const StickVector& acceleration) {
  if (acceleration.size() == 1) return acceleration / mobility(0, 0);
  return mobility.completeOrthogonalDecomposition().solve(acceleration);
}

void settle_slips(const StickMobility& mobility, const StickVector& acceleration, const StickVector& limit,
                  Slip* slips, StickVector& force) {
  const Eigen::Index count = limit.size();
  force.setZero(count);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double change = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
      const double left = acceleration(i) - mobility.row(i).dot(force);
      const double next = std::clamp(force(i) + left / mobility(i, i), -limit(i), limit(i));
      change = std::max(change, std::abs(next - force(i)));
      force(i) = next;
    }
    if (count == 1 || change <= settled * limit.maxCoeff()) break;
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    const bool slips_now = std::abs(force(i)) >= limit(i);
    const double way = limit(i) > 0 ? force(i) : acceleration(i) - mobility.row(i).dot(force);
    slips[i] = !slips_now ? Slip::sticking : way >= 0 ? Slip::forward : Slip::backward;
  }
}

}  // namespace rubsweep::contact
