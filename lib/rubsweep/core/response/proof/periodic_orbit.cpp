#include "rubsweep/core/response/proof/periodic_orbit.hpp"

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/lu.hpp"
#include "rubsweep/core/numerics/newton.hpp"

namespace rubsweep::response::proof {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr numerics::NewtonLimits newton_limits{.iterations = 8, .free_iterations = 1, .growth = 0.5};
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

/// Newton's iteration for an orbit of `order` turns; see numerics::newton. The map is `roughly` until the
/// return nearly closes.
struct OrbitNewton {
  const TurnMap &turn, &roughly;
  const VectorXd& start;
  int order = 0;
  VectorXd x = start;
  std::optional<Return> back{};
  VectorXd next_step{};
  bool exactly = false;

  std::optional<double> error(int, double) {
    back = return_of(exactly ? turn : roughly, x, order);
    if (back && !exactly && largest(back->defect) < closed) back = return_of(turn, x, order);
    if (!back) return std::nullopt;
    const double error = largest(back->defect);
    exactly = error < nearly_closed;
    next_step =
        numerics::dense::solve(MatrixXd::Identity(x.size(), x.size()) - back->monodromy, back->defect);
    return error;
  }

  /// The last step takes the error to rounding.
  bool converged(int, double error, double) {
    if (!(error < closed)) return false;
    if (next_step.allFinite()) x += next_step;
    return true;
  }

  bool step(int i) {
    if (numerics::dense::spectral_radius(back->monodromy) > (i == 0 ? hopeless_from_afar : 1)) return false;
    x += next_step;
    return x.allFinite() && largest(x - start) <= farthest_orbit;
  }
};

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
  OrbitNewton found{.turn = turn, .roughly = roughly, .start = start, .order = order};
  if (!numerics::newton(found, newton_limits)) return std::nullopt;
  StableOrbit orbit{.order = found.back->order, .sections = {}, .transitions = {}, .floquet_modulus = 0};
  orbit.floquet_modulus = numerics::dense::spectral_radius(found.back->monodromy);
  if (!(orbit.floquet_modulus < largest_floquet_modulus) || !list_turns(turn, found.x, orbit))
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
