#include "rubsweep/response/proof/approach.hpp"

#include <algorithm>
#include <vector>

namespace rubsweep::response::proof {
namespace {

using Eigen::VectorXd;

constexpr double farther = 4;

VectorXd off(std::span<const double> section, const StableOrbit& orbit, std::size_t turn) {
  return Eigen::Map<const VectorXd>(section.data(), static_cast<Eigen::Index>(section.size())) -
         orbit.sections[turn];
}

/// Follows until `near(size, offset)`, with the size that `size_of(offset, turn of the orbit)` gives.
template <class SizeOf, class Near>
bool follow(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit, long most_turns,
            const SizeOf& size_of, const Near& near) {
  std::vector<double> now(section.begin(), section.end());
  const double first = size_of(off(now, orbit, 0), std::size_t{0});
  for (long k = 0;; ++k) {
    const auto at = static_cast<std::size_t>(k % orbit.order);
    const VectorXd offset = off(now, orbit, at);
    const double size = size_of(offset, at);
    if (near(size, offset)) return true;
    if (!(size <= farther * first) || k == most_turns || !turn(now, nullptr)) return false;
  }
}

}  // namespace

double adapted_distance(std::span<const double> section, const StableOrbit& orbit,
                        const AdaptedNorms& norms) {
  return (norms.norm.front() * off(section, orbit, 0)).norm();
}

bool comes_near(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                const AdaptedNorms& norms, const Nearness& wanted, long most_turns) {
  const auto size_of = [&norms](const VectorXd& offset, std::size_t at) {
    return (norms.norm[at] * offset).norm();
  };
  return follow(turn, section, orbit, most_turns, size_of, [&wanted](double size, const VectorXd& offset) {
    return size <= wanted.adapted || offset.cwiseAbs().maxCoeff() <= wanted.largest;
  });
}

bool comes_inside(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                  const SplitNorms& norms, const integrate::exact::Parts& radii, long most_turns) {
  const auto size_of = [&](const VectorXd& offset, std::size_t at) {
    const integrate::exact::Parts parts = parts_of(norms, at, offset);
    return std::max(parts.fast / radii.fast, parts.slow / radii.slow);
  };
  return follow(turn, section, orbit, most_turns, size_of,
                [](double size, const VectorXd&) { return size <= 1; });
}

}  // namespace rubsweep::response::proof
