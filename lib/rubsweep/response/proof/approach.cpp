#include "rubsweep/response/proof/approach.hpp"

#include <vector>

namespace rubsweep::response::proof {
namespace {

using Eigen::VectorXd;

constexpr double farther = 4;

VectorXd off(std::span<const double> section, const StableOrbit& orbit, std::size_t turn) {
  return Eigen::Map<const VectorXd>(section.data(), static_cast<Eigen::Index>(section.size())) -
         orbit.sections[turn];
}

}  // namespace

double adapted_distance(std::span<const double> section, const StableOrbit& orbit,
                        const AdaptedNorms& norms) {
  return (norms.norm.front() * off(section, orbit, 0)).norm();
}

bool comes_near(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                const AdaptedNorms& norms, const Nearness& wanted, long most_turns) {
  std::vector<double> now(section.begin(), section.end());
  const double first = adapted_distance(now, orbit, norms);
  for (long k = 0;; ++k) {
    const auto at = static_cast<std::size_t>(k % orbit.order);
    const VectorXd distance = off(now, orbit, at);
    const double adapted = (norms.norm[at] * distance).norm();
    if (adapted <= wanted.adapted || distance.cwiseAbs().maxCoeff() <= wanted.largest) return true;
    if (!(adapted <= farther * first) || k == most_turns || !turn(now, nullptr)) return false;
  }
}

}  // namespace rubsweep::response::proof
