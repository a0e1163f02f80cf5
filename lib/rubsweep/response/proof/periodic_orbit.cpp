#include "rubsweep/response/proof/periodic_orbit.hpp"

#include "rubsweep/numerics/eigenvalues.hpp"
#include "rubsweep/numerics/lu.hpp"

namespace rubsweep::response::proof {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int newton_iterations = 8;
constexpr double closed = 1e-11;        ///< return error of an orbit found, in (clearance, clearance omega)
constexpr double nearly_closed = 1e-5;  ///< from here on rough derivatives would cost a step more
constexpr double returns_early = 1e-7;  ///< return error that makes fewer turns the period
/// Largest multiplier at the transient from which Newton's iteration is tried: no proven orbit had a larger
/// one there, nor one above 1 at a later iterate; a refused orbit is tried again.
constexpr double hopeless_from_afar = 1.2;

double largest(const VectorXd& x) { return x.cwiseAbs().maxCoeff(); }

bool advance(const TurnMap& turn, VectorXd& x, MatrixXd* disturbances) {
  return turn({x.data(), static_cast<std::size_t>(x.size())}, disturbances) && x.allFinite();
}

struct Return {
  int order = 0;
  VectorXd defect;  ///< distance of the section from itself after so many turns
  MatrixXd monodromy;
};

/// The return after `order` turns from x, or after fewer that divide them when it is as good as there.
std::optional<Return> return_of(const TurnMap& turn, const VectorXd& x, int order) {
  VectorXd now = x;
  MatrixXd monodromy = MatrixXd::Identity(x.size(), x.size());
  for (int k = 1; k <= order; ++k) {
    if (!advance(turn, now, &monodromy)) return std::nullopt;
    if (k == order || (order % k == 0 && largest(now - x) < returns_early))
      return Return{k, now - x, monodromy};
  }
  return std::nullopt;
}

struct Closed {
  int order = 0;
  VectorXd x;
  MatrixXd monodromy;
};

std::optional<Closed> close(const TurnMap& turn, const TurnMap& roughly, const VectorXd& start, int order) {
  VectorXd x = start;
  double last = 0;
  bool exactly = false;
  for (int i = 0; i < newton_iterations; ++i) {
    const auto back = return_of(exactly ? turn : roughly, x, order);
    if (!back) return std::nullopt;
    const double error = largest(back->defect);
    const bool by_rough_map = !exactly;
    exactly = error < nearly_closed;
    if (error < closed && by_rough_map) continue;
    const MatrixXd slope = MatrixXd::Identity(x.size(), x.size()) - back->monodromy;
    const VectorXd step = numerics::solve(slope, back->defect);
    // The last step takes the error to rounding.
    if (error < closed)
      return Closed{back->order, step.allFinite() ? VectorXd(x + step) : x, back->monodromy};
    if (i > 0 && error > last / 2) return std::nullopt;
    if (numerics::spectral_radius(back->monodromy) > (i == 0 ? hopeless_from_afar : 1)) return std::nullopt;
    last = error;
    x += step;
    if (!x.allFinite() || largest(x - start) > farthest_orbit) return std::nullopt;
  }
  return std::nullopt;
}

/// The orbit's own turns, one by one.
bool list_turns(const TurnMap& turn, VectorXd x, StableOrbit& orbit) {
  for (int k = 0; k < orbit.order; ++k) {
    orbit.sections.push_back(x);
    orbit.transitions.emplace_back(MatrixXd::Identity(x.size(), x.size()));
    if (!advance(turn, x, &orbit.transitions.back())) return false;
  }
  return true;
}

}  // namespace

std::optional<StableOrbit> find_orbit(const TurnMap& turn, std::span<const double> section, int order) {
  return find_orbit(turn, turn, section, order);
}

std::optional<StableOrbit> find_orbit(const TurnMap& turn, const TurnMap& roughly,
                                      std::span<const double> section, int order) {
  const VectorXd start =
      Eigen::Map<const VectorXd>(section.data(), static_cast<Eigen::Index>(section.size()));
  const auto closed_orbit = close(turn, roughly, start, order);
  if (!closed_orbit) return std::nullopt;
  StableOrbit orbit{.order = closed_orbit->order, .sections = {}, .transitions = {}, .floquet_modulus = 0};
  orbit.floquet_modulus = numerics::spectral_radius(closed_orbit->monodromy);
  if (!(orbit.floquet_modulus < largest_floquet_modulus) || !list_turns(turn, closed_orbit->x, orbit))
    return std::nullopt;
  return orbit;
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

}  // namespace rubsweep::response::proof
