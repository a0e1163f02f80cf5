#include "rubsweep/response/turning_cycle.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "rubsweep/response/floquet.hpp"

namespace rubsweep::response {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using integrate::TurningArc;

constexpr int newton_iterations = 8;
constexpr double period_changes = 0.2;  ///< share of its first guess by which the period may change
constexpr int most_periods = 8;         ///< looked for in a cycle that closes
constexpr double returns_early = 1e-4;  ///< return error that makes a fraction the period
constexpr double stands_still = 1e-5;   ///< rate below which a cycle is no cycle but a point

/// In (clearance, clearance omega).
struct Accuracy {
  double closed = 0;   ///< return error of a cycle found
  double trivial = 0;  ///< how far from 1 the trivial multiplier may be
};
constexpr Accuracy rough{.closed = 1e-5, .trivial = 1e-2};
constexpr Accuracy exact{.closed = 1e-9, .trivial = 1e-5};

double largest(const VectorXd& x) { return x.cwiseAbs().maxCoeff(); }

struct Closed {
  VectorXd x;
  TurningArc once;
  TurningArc first;  ///< from the start, over the guessed period
};

/// Newton step of (state, period), the state staying across `across`.
VectorXd newton_step(const VectorXd& x, const TurningArc& arc, const VectorXd& rate_at_end,
                     const VectorXd& across) {
  const Eigen::Index n = x.size();
  MatrixXd bordered = MatrixXd::Zero(n + 1, n + 1);
  bordered.topLeftCorner(n, n) = arc.transition - MatrixXd::Identity(n, n);
  bordered.topRightCorner(n, 1) = rate_at_end;
  bordered.bottomLeftCorner(1, n) = across.transpose();
  VectorXd defect = VectorXd::Zero(n + 1);
  defect.head(n) = arc.end - x;
  return bordered.partialPivLu().solve(-defect);
}

std::optional<Closed> close(const TurningMotion& motion, const TurningMotion::Flow& flow,
                            const VectorXd& start, double guess_rad, double closed) {
  const VectorXd across = motion.rate(start);
  VectorXd x = start;
  double period = guess_rad, last = 0;
  std::optional<TurningArc> first;
  for (int i = 0; i < newton_iterations; ++i) {
    const auto arc = flow(x, period);
    if (!arc || !arc->end.allFinite()) return std::nullopt;
    if (!first) first = arc;
    const double error = largest(arc->end - x);
    if (error < closed) return Closed{x, *arc, *first};
    if (error > farthest_orbit || (i > 2 && error > last / 2)) return std::nullopt;
    last = error;
    const VectorXd step = newton_step(x, *arc, motion.rate(arc->end), across);
    x += step.head(x.size());
    period += step(x.size());
    if (!x.allFinite() || largest(x - start) > farthest_orbit ||
        !(std::abs(period - guess_rad) <= period_changes * guess_rad))
      return std::nullopt;
  }
  return std::nullopt;
}

/// Largest modulus of all multipliers but the trivial one; empty when that is not where it must be or another
/// is too large. How far the trivial one is off 1 shows how well they are known.
std::optional<double> stable_modulus(const MatrixXd& monodromy, double trivial_within) {
  const Eigen::VectorXcd multipliers = monodromy.eigenvalues();
  Eigen::Index trivial = 0;
  const double off = (multipliers.array() - 1.0).abs().minCoeff(&trivial);
  if (!(off < trivial_within)) return std::nullopt;
  double modulus = 0;
  for (Eigen::Index k = 0; k < multipliers.size(); ++k) {
    if (k != trivial) modulus = std::max(modulus, std::abs(multipliers(k)));
  }
  if (!(modulus < std::min(largest_floquet_modulus, 1 - off))) return std::nullopt;
  return modulus;
}

/// Whether the transient ends where the linear map about the cycle says, after one period or after so many as
/// it takes to come back: what alternates about an orbit bends from its linear map in one period and back in
/// the next. What it misses must be less than what the cycle draws it in by, or a weak cycle may not hold it.
/// Being early or late is no distance: only what lies across the orbit counts.
bool approaches(const TurningMotion& motion, const VectorXd& start, const Closed& cycle, double modulus,
                int periods) {
  const VectorXd from = start - cycle.x, along = motion.rate(cycle.x).normalized();
  if (largest(from) < on_the_orbit) return true;
  VectorXd expected = from, image = cycle.first.end;
  for (int k = 1;; ++k) {
    expected = cycle.once.transition * expected;
    const VectorXd missed = image - cycle.x - expected;
    const double share = std::min(linear_share, 1 - std::pow(modulus, k));
    if (largest(missed - along * along.dot(missed)) <= share * largest(from)) return true;
    if (k >= periods) return false;
    const auto arc = motion.roughly(image, cycle.once.angle_rad);
    if (!arc) return false;
    image = arc->end;
  }
}

/// Whole periods in the cycle: Newton's iteration may have closed several at once.
int periods_in(const TurningMotion& motion, const Closed& cycle) {
  for (int k = most_periods; k > 1; --k) {
    const auto arc = motion.roughly(cycle.x, cycle.once.angle_rad / k);
    if (arc && largest(arc->end - cycle.x) < returns_early) return k;
  }
  return 1;
}

std::optional<TurningCycle> exact_cycle(const TurningMotion& motion, const VectorXd& x, double period_rad) {
  auto cycle = close(motion, motion.exactly, x, period_rad, exact.closed);
  if (!cycle) return std::nullopt;
  const auto modulus = stable_modulus(cycle->once.transition, exact.trivial);
  if (!modulus) return std::nullopt;
  return TurningCycle{cycle->x, std::move(cycle->once), *modulus};
}

}  // namespace

std::optional<TurningCycle> prove_cycle(const TurningMotion& motion, const VectorXd& start,
                                        const std::vector<double>& periods_rad) {
  for (const double period : periods_rad) {
    const auto nearly = close(motion, motion.roughly, start, period, rough.closed);
    if (!nearly || largest(motion.rate(nearly->x)) < stands_still) continue;
    const auto modulus = stable_modulus(nearly->once.transition, rough.trivial);
    if (!modulus) continue;
    const auto periods = static_cast<int>(std::lround(periods_rad.back() / period));
    if (!approaches(motion, start, *nearly, *modulus, periods)) return std::nullopt;
    return exact_cycle(motion, nearly->x, nearly->once.angle_rad / periods_in(motion, *nearly));
  }
  return std::nullopt;
}

}  // namespace rubsweep::response
