#include "rubsweep/fit/ramp_window.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "rubsweep/error.hpp"

namespace rubsweep::fit {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Places of a window, from -1 to 1, that a polynomial of fourth degree goes through.
constexpr std::array<double, 5> places{-1, -0.5, 0, 0.5, 1};
constexpr auto degrees = static_cast<Eigen::Index>(places.size());

/// Weights of values at `places` in the means, over a window of some turns, of themselves and times
/// e^{-2i phi}, phi = 0 in the middle.
struct WindowWeights {
  Eigen::RowVectorXd mean;
  Eigen::RowVectorXcd mirrored;
};

WindowWeights window_weights(double turns) {
  // Means of the powers u^p and u^p e^{-i k u}, by parts, where e^{ik} = 1.
  const double k = 2 * pi * turns;
  Eigen::MatrixXd powers(degrees, degrees);
  Eigen::RowVectorXd mean(degrees);
  Eigen::RowVectorXcd mirrored(degrees);
  Complex before = 0;
  for (Eigen::Index p = 0; p < degrees; ++p) {
    for (Eigen::Index j = 0; j < degrees; ++j)
      powers(p, j) = std::pow(places[static_cast<std::size_t>(j)], p);
    const auto power = static_cast<double>(p);
    const bool odd = p % 2 == 1;
    mean(p) = odd ? 0 : 1 / (power + 1);
    before = (odd ? Complex(0, 1 / k) : 0) - Complex(0, power / k) * before;
    mirrored(p) = before;
  }
  const Eigen::MatrixXd inverse = powers.inverse();
  return {(inverse * mean.transpose()).transpose(),
          (inverse.cast<Complex>() * mirrored.transpose()).transpose()};
}

}  // namespace

std::vector<WindowNode> window_nodes(const Ramp& ramp, const std::vector<double>& t_s, double window_turns) {
  std::vector<WindowNode> nodes;
  const WindowWeights weights = window_weights(std::max(window_turns, 1.0));
  for (std::size_t k = 0; k < t_s.size(); ++k) {
    const auto point = static_cast<Eigen::Index>(k);
    const double now_hz = speed_hz(ramp, t_s[k]);
    if (!(now_hz > 0)) throw ConfigError("a ramp reaches speed 0, allowed: speeds above it");
    const double half_s = window_turns / now_hz / 2;
    if (!(half_s > 0)) {
      nodes.push_back({t_s[k], 1, 0, point});
      continue;
    }
    const double change = (speed_hz(ramp, t_s[k] + half_s) - speed_hz(ramp, t_s[k] - half_s)) / now_hz;
    for (Eigen::Index j = 0; j < degrees; ++j) {
      const double u = places[static_cast<std::size_t>(j)];
      nodes.push_back(
          {t_s[k] + half_s * (u - change * u * u / 4), weights.mean(j), weights.mirrored(j), point});
    }
  }
  std::ranges::sort(nodes, {}, &WindowNode::t_s);
  return nodes;
}

}  // namespace rubsweep::fit
