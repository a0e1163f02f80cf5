#include "rubsweep/core/response/proof/approach.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rubsweep::response::proof {
namespace {

using Eigen::VectorXd;

constexpr double farther = 4;
constexpr int predicted_periods = 3;

VectorXd off(std::span<const double> section, const StableOrbit& orbit, std::size_t turn) {
  return Eigen::Map<const VectorXd>(section.data(), static_cast<Eigen::Index>(section.size())) -
         orbit.sections[turn];
}

/// Follows until `near(turn of the orbit, offset, size)`, with the size that `size_of(offset, turn of the
/// orbit)` gives, for `most_turns(first size, size)` turns at most.
template <class SizeOf, class Near, class MostTurns>
bool follow(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
            const SizeOf& size_of, const Near& near, const MostTurns& most_turns) {
  std::vector<double> now(section.begin(), section.end());
  const double first = size_of(off(now, orbit, 0), std::size_t{0});
  for (long k = 0;; ++k) {
    const auto at = static_cast<std::size_t>(k % orbit.order);
    const VectorXd offset = off(now, orbit, at);
    const double size = size_of(offset, at);
    if (near(at, offset, size)) return true;
    if (!(size <= farther * first) || static_cast<double>(k) >= most_turns(first, size) ||
        !turn(now, nullptr))
      return false;
  }
}

}  // namespace

double adapted_distance(std::span<const double> section, const StableOrbit& orbit,
                        const AdaptedNorms& norms) {
  return (norms.norm.front() * off(section, orbit, 0)).norm();
}

bool comes_near(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                const AdaptedNorms& norms, const Nearness& wanted, const Patience& patience) {
  const auto size_of = [&norms](const VectorXd& offset, std::size_t at) {
    return (norms.norm[at] * offset).norm();
  };
  LinearConvergenceTest convergence(predicted_periods * orbit.order);
  const double of_a_period = std::pow(norms.contraction, orbit.order);
  VectorXd predicted;
  double first = 0, last = 0, a_period_ago = 0;
  const auto near = [&](std::size_t at, const VectorXd& offset, double size) {
    if (size <= wanted.adapted || offset.cwiseAbs().maxCoeff() <= wanted.largest) return true;
    if (!wanted.converges) return false;
    if (predicted.size() == 0) {
      first = size;
    } else {
      convergence.add_prediction(size_of(offset - predicted, at), last, norms.contraction);
      if (at == 0) convergence.add_contraction(a_period_ago, size, of_a_period);
    }
    predicted = orbit.transitions[at] * offset;
    last = size;
    if (at == 0) a_period_ago = size;
    return convergence.passed(size, first);
  };
  return follow(turn, section, orbit, size_of, near,
                [&](double from, double size) { return patience.turns(norms.contraction, from, size); });
}

bool comes_inside(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                  const SplitNorms& norms, const integrate::exact::tube::Parts& radii, double most_turns) {
  const auto size_of = [&](const VectorXd& offset, std::size_t at) {
    const integrate::exact::tube::Parts parts = parts_of(norms, at, offset);
    return std::max(parts.fast / radii.fast, parts.slow / radii.slow);
  };
  const auto near = [](std::size_t, const VectorXd&, double size) { return size <= 1; };
  const auto turns = [most_turns](double, double) { return most_turns; };
  return follow(turn, section, orbit, size_of, near, turns);
}

}  // namespace rubsweep::response::proof
