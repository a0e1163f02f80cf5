#include "rubsweep/core/response/rotating/limit_cycle.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/newton.hpp"
#include "rubsweep/core/response/proof/approach.hpp"
#include "rubsweep/core/response/proof/periodic_orbit.hpp"

namespace rubsweep::response::rotating {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double first_tolerance = 1e-4, rough_tolerance = 1e-6, tolerance_of_a_cycle = 1e-8;

constexpr numerics::NewtonLimits cycle_newton{.iterations = 8, .free_iterations = 3, .growth = 0.5};
/// Largest return error of a guess. In figure 11, 40 of 715 guesses had larger errors, and none of them led
/// to the cycle that the transient reached.
constexpr double farthest_guess = 0.08;
constexpr double share_of_closed = 0.01;  ///< share of `closed` to be reached with a kept derivative
constexpr double period_changes = 0.2;    ///< largest change of the period, as a share of its first guess
constexpr int most_parts = 64;          ///< parts of a found period after one of which it may already return
constexpr double returns_early = 1e-4;  ///< return error at which a part is the period
constexpr double stands_still = 1e-5;   ///< rate below which a cycle is only a point
constexpr double followed_down = 1e-3;  ///< share of its distance down to which a transient is followed
constexpr double near_by = 1e-5;  ///< or this distance, because smaller changes are noise of the rough flow
constexpr proof::Patience patience{.start = 64, .most = 3000};  ///< limits in periods

/// Number of predicted returns in a row after which half of the distance is enough.
constexpr int predicted_in_a_row = 3;

/// Limits of Newton's iteration, in (clearance, clearance omega).
struct Accuracy {
  double closed = 0;        ///< return error of a found cycle
  double trivial = 0;       ///< largest deviation of the trivial multiplier from 1
  double known_within = 0;  ///< return error below which the derivative is kept
};
constexpr Accuracy rough{.closed = 1e-5, .trivial = 1e-2, .known_within = 1e-3};
constexpr Accuracy exact{.closed = 1e-9, .trivial = 1e-5, .known_within = 0};

struct Closed {
  VectorXd x;
  double period_rad = 0;
  RotatingArc once;  ///< arc from x, or from a point so near that the derivative is accurate enough
  /// State after Newton's next step, kept so that an iteration with another accuracy need not repeat it.
  VectorXd next_x;
  double next_period_rad = 0;
};

/// Newton's steps in (state, period) by the derivative of one arc, on the plane normal to `across`.
class NewtonSteps {
 public:
  NewtonSteps(const RotatingArc& arc, const VectorXd& rate_at_end, const VectorXd& across)
      : factors_(bordered(arc, rate_at_end, across)) {}

  VectorXd from(const VectorXd& x, const VectorXd& end) const {
    VectorXd defect = VectorXd::Zero(x.size() + 1);
    defect.head(x.size()) = end - x;
    return factors_.solve(VectorXd(-defect));
  }

 private:
  static MatrixXd bordered(const RotatingArc& arc, const VectorXd& rate_at_end, const VectorXd& across) {
    const Eigen::Index n = across.size();
    MatrixXd matrix = MatrixXd::Zero(n + 1, n + 1);
    matrix.topLeftCorner(n, n) = arc.transition - MatrixXd::Identity(n, n);
    matrix.topRightCorner(n, 1) = rate_at_end;
    matrix.bottomLeftCorner(1, n) = across.transpose();
    return matrix;
  }

  numerics::dense::LuFactors factors_;
};

/// Flows for Newton's steps. The first step is made with the coarser flow, which gains as much from far away.
struct Flows {
  const RotatingMotion::Flow &at_first, &then;
};

/// Newton's iteration for (state, period) of a cycle; see numerics::newton.
struct CycleNewton {
  const RotatingMotion& motion;
  const Flows& flows;
  const VectorXd& start;
  double guess_rad = 0;
  const Accuracy& wanted;
  VectorXd x = start;
  double period = guess_rad;
  VectorXd across = motion.rate(start);
  std::optional<RotatingArc> arc{};
  std::optional<NewtonSteps> steps{};
  VectorXd next_step{};
  bool known = false;  ///< true: the derivative is kept from an earlier arc

  std::optional<VectorXd> end_of_arc(int i) {
    if (known) return motion.end(x, period);
    if (!(arc = (i == 0 ? flows.at_first : flows.then)(x, period)) || !arc->end.allFinite())
      return std::nullopt;
    steps.emplace(*arc, motion.rate(arc->end), across);
    return arc->end;
  }

  std::optional<double> error(int i, double last) {
    known = last < wanted.known_within;
    const std::optional<VectorXd> end = end_of_arc(i);
    if (!end || !end->allFinite()) return std::nullopt;
    next_step = steps->from(x, *end);
    const double error = (*end - x).cwiseAbs().maxCoeff();
    if (error > (i == 0 ? farthest_guess : proof::farthest_orbit)) return std::nullopt;
    return error;
  }

  /// The derivative is kept while it still gains much, so that the exact iteration starts nearer to the
  /// cycle.
  bool converged(int, double error, double last) const {
    const bool goes_on = known && error > share_of_closed * wanted.closed && error < last / 10;
    return error < wanted.closed && !goes_on;
  }

  bool step(int) {
    x += next_step.head(x.size());
    period += next_step(x.size());
    return x.allFinite() && (x - start).cwiseAbs().maxCoeff() <= proof::farthest_orbit &&
           std::abs(period - guess_rad) <= period_changes * guess_rad;
  }
};

std::optional<Closed> close(const RotatingMotion& motion, const Flows& flows, const VectorXd& start,
                            double guess_rad, const Accuracy& wanted) {
  CycleNewton found{
      .motion = motion, .flows = flows, .start = start, .guess_rad = guess_rad, .wanted = wanted};
  if (!numerics::newton(found, cycle_newton)) return std::nullopt;
  const VectorXd &x = found.x, &step = found.next_step;
  if (!step.allFinite()) return Closed{x, found.period, *found.arc, x, found.period};
  return Closed{x, found.period, *found.arc, x + step.head(x.size()), found.period + step(x.size())};
}

/// Largest modulus of all multipliers except the trivial one. Empty when the trivial multiplier, which shows
/// the accuracy of all, differs too much from 1, or when another multiplier is too large.
std::optional<double> stable_modulus(const MatrixXd& monodromy, double trivial_within) {
  const Eigen::VectorXcd multipliers = numerics::dense::eigenvalues(monodromy);
  Eigen::Index trivial = 0;
  const double off = (multipliers.array() - 1.0).abs().minCoeff(&trivial);
  if (!(off < trivial_within)) return std::nullopt;
  double modulus = 0;
  for (Eigen::Index k = 0; k < multipliers.size(); ++k) {
    if (k != trivial) modulus = std::max(modulus, std::abs(multipliers(k)));
  }
  if (!(modulus < std::min(proof::largest_floquet_modulus, 1 - off))) return std::nullopt;
  return modulus;
}

/// Follows the transient period by period until it is near the cycle. "Near" means a thousandth of its first
/// distance in the adapted norm of the return map across the cycle, `near_by`, or half of the distance with
/// LinearConvergenceTest passed. A phase shift is no distance: each period is shortened or extended by the
/// previous offset along the motion.
bool comes_near(const RotatingMotion& motion, const VectorXd& start, const Closed& cycle) {
  const Eigen::Index n = start.size();
  const VectorXd rate = motion.rate(cycle.x), along = rate.normalized();
  const MatrixXd across = MatrixXd::Identity(n, n) - along * along.transpose();
  const auto norms = proof::adapted_norms({across * cycle.once.transition * across});
  if (!norms) return false;
  const MatrixXd& norm = norms->norm.front();
  VectorXd image = start, predicted;
  double first = 0, last = 0;
  proof::LinearConvergenceTest convergence(predicted_in_a_row);
  for (int k = 0;; ++k) {
    const VectorXd off = across * (image - cycle.x);
    const double distance = (norm * off).norm();
    if (k == 0) {
      first = distance;
    } else {
      convergence.add_prediction((norm * (off - predicted)).norm(), last, norms->contraction);
      convergence.add_contraction(last, distance, norms->contraction);
    }
    if (off.cwiseAbs().maxCoeff() < near_by || distance < followed_down * first ||
        convergence.passed(distance, first))
      return true;
    if (!(distance < 4 * first) || k >= patience.turns(norms->contraction, first, distance)) return false;
    predicted = across * (cycle.once.transition * off);
    last = distance;
    const double late_rad = along.dot(image - cycle.x) / rate.norm();
    // A state that is ahead by a period or more approaches something else, and no flow runs backwards.
    const double angle_rad = cycle.period_rad - late_rad;
    if (!(angle_rad > 0)) return false;
    const auto end = motion.end(image, angle_rad);
    if (!end || !end->allFinite()) return false;
    image = *end;
  }
}

std::optional<LimitCycle> exact_cycle(const RotatingMotion& motion, const VectorXd& x, double period_rad) {
  auto cycle = close(motion, {motion.exactly, motion.exactly}, x, period_rad, exact);
  if (!cycle) return std::nullopt;
  const auto modulus = stable_modulus(cycle->once.transition, exact.trivial);
  if (!modulus) return std::nullopt;
  return LimitCycle{cycle->x, std::move(cycle->once), *modulus};
}

constexpr bool is_prime(int k) {
  for (int j = 2; j * j <= k; ++j) {
    if (k % j == 0) return false;
  }
  return k > 1;
}

/// The largest prime k <= `most` for which the motion returns to `x` after 1/k of the period; 1 if there is
/// none.
int parts_of(const RotatingMotion& motion, const VectorXd& x, double period_rad, int most) {
  VectorXd here = x;
  double passed_rad = 0;
  for (int k = most; k > 1; --k) {
    if (!is_prime(k)) continue;
    const auto end = motion.end(here, period_rad / k - passed_rad);
    if (!end) break;
    here = *end;
    passed_rad = period_rad / k;
    if ((here - x).cwiseAbs().maxCoeff() < returns_early) return k;
  }
  return 1;
}

/// Newton's iteration may close several periods at once, dozens for a whip. This function finds the smallest
/// period that closes. If the motion returns after a fraction of the period, it also returns after one that
/// is a prime number of times shorter.
std::optional<LimitCycle> smallest_cycle(const RotatingMotion& motion, const Closed& cycle) {
  int parts = 1;
  for (int k = most_parts; k > 1; parts *= k)
    k = parts_of(motion, cycle.next_x, cycle.next_period_rad / parts, most_parts / parts);
  if (parts > 1) {
    if (auto found = exact_cycle(motion, cycle.next_x, cycle.next_period_rad / parts)) return found;
  }
  return exact_cycle(motion, cycle.next_x, cycle.next_period_rad);
}

}  // namespace

std::optional<LimitCycle> prove_limit_cycle(const RotatingMotion& motion, const VectorXd& start,
                                            const std::vector<double>& periods_rad) {
  for (const double period : periods_rad) {
    const auto nearly = close(motion, {motion.at_first, motion.roughly}, start, period, rough);
    if (!nearly || motion.rate(nearly->x).cwiseAbs().maxCoeff() < stands_still) continue;
    if (!stable_modulus(nearly->once.transition, rough.trivial)) continue;
    if (!comes_near(motion, start, *nearly)) return std::nullopt;
    return smallest_cycle(motion, *nearly);
  }
  return std::nullopt;
}

CycleFlows::CycleFlows(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                       int samples_per_revolution)
    : exactly(RotatingFlow(scene, solver, samples_per_revolution)
                  .with(std::min(solver.relative_tolerance, tolerance_of_a_cycle), samples_per_revolution)),
      roughly(exactly.with(rough_tolerance, 0)),
      at_first(exactly.with(first_tolerance, 0)) {}

RotatingMotion CycleFlows::motion(const RotatingField& field) const {
  const auto from = [](const RotatingFlow& flow) {
    return [&flow](const VectorXd& state, double angle_rad) { return flow.from(state, angle_rad); };
  };
  return {[&field](const VectorXd& state) { return field.rate(state); }, from(at_first), from(roughly),
          from(exactly),
          [this](const VectorXd& state, double angle_rad) { return roughly.end_from(state, angle_rad); }};
}

}  // namespace rubsweep::response::rotating
