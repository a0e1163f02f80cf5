#include "rubsweep/response/floquet.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace rubsweep::response {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int newton_iterations = 8;
constexpr double closed = 1e-11;        ///< return error of an orbit found, in (clearance, clearance omega)
constexpr double returns_early = 1e-7;  ///< return error that makes fewer turns the period
constexpr int most_periods_followed = 64;

/// `order` turns from x; the product of their derivatives.
std::optional<VectorXd> after(const TurnMap& turn, VectorXd x, int order, MatrixXd* monodromy) {
  MatrixXd one;
  if (monodromy) monodromy->setIdentity(x.size(), x.size());
  for (int k = 0; k < order; ++k) {
    if (!turn({x.data(), static_cast<std::size_t>(x.size())}, monodromy ? &one : nullptr))
      return std::nullopt;
    if (monodromy) *monodromy = (one * *monodromy).eval();
  }
  if (!x.allFinite()) return std::nullopt;
  return x;
}

double largest(const VectorXd& x) { return x.cwiseAbs().maxCoeff(); }

struct Closed {
  VectorXd x;
  MatrixXd monodromy;
};

std::optional<Closed> close(const TurnMap& turn, const VectorXd& start, int order) {
  VectorXd x = start;
  double last = 0;
  for (int i = 0; i < newton_iterations; ++i) {
    MatrixXd monodromy;
    const auto image = after(turn, x, order, &monodromy);
    if (!image) return std::nullopt;
    const VectorXd defect = *image - x;
    const double error = largest(defect);
    if (error < closed) return Closed{x, monodromy};
    if (i > 0 && error > last / 2) return std::nullopt;
    last = error;
    const MatrixXd slope = MatrixXd::Identity(x.size(), x.size()) - monodromy;
    x += slope.partialPivLu().solve(defect);
    if (!x.allFinite() || largest(x - start) > farthest_orbit) return std::nullopt;
  }
  return std::nullopt;
}

/// The transient follows the map linearised about the orbit until its distance has halved.
bool approaches(const TurnMap& turn, const VectorXd& start, const Closed& orbit, int order) {
  VectorXd predicted = start - orbit.x, now = start;
  const double from = largest(predicted);
  if (from < 1e3 * closed) return true;
  for (int k = 0; k < most_periods_followed && largest(predicted) > from / 2; ++k) {
    const auto image = after(turn, now, order, nullptr);
    if (!image) return false;
    now = *image;
    predicted = orbit.monodromy * predicted;
    if (largest(now - orbit.x - predicted) > linear_share * from) return false;
  }
  return true;
}

/// Fewest turns, dividing `order`, after which the orbit returns.
int smallest_order(const TurnMap& turn, const VectorXd& x, int order) {
  VectorXd now = x;
  for (int n = 1; n < order; ++n) {
    const auto next = after(turn, now, 1, nullptr);
    if (!next) return order;
    now = *next;
    if (order % n == 0 && largest(now - x) < returns_early) return n;
  }
  return order;
}

}  // namespace

std::optional<StableOrbit> prove_orbit(const TurnMap& turn, std::span<const double> section, int order) {
  const VectorXd start =
      Eigen::Map<const VectorXd>(section.data(), static_cast<Eigen::Index>(section.size()));
  const auto orbit = close(turn, start, order);
  if (!orbit) return std::nullopt;
  const double modulus = orbit->monodromy.eigenvalues().cwiseAbs().maxCoeff();
  if (!(modulus < largest_floquet_modulus)) return std::nullopt;
  if (!approaches(turn, start, *orbit, order)) return std::nullopt;
  if (const int fewer = smallest_order(turn, orbit->x, order); fewer < order)
    return prove_orbit(turn, section, fewer);
  return StableOrbit{order, {orbit->x.data(), orbit->x.data() + orbit->x.size()}, modulus};
}

bool differentiate(const std::function<bool(std::span<double>)>& turn, std::span<double> section, double step,
                   Eigen::MatrixXd& transition) {
  const auto n = static_cast<Eigen::Index>(section.size());
  const std::vector<double> here(section.begin(), section.end());
  transition.resize(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    std::vector<double> above = here, below = here;
    above[static_cast<std::size_t>(j)] += step;
    below[static_cast<std::size_t>(j)] -= step;
    if (!turn(above) || !turn(below)) return false;
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      transition(i, j) = (above[k] - below[k]) / (2 * step);
    }
  }
  return turn(section);
}

}  // namespace rubsweep::response
