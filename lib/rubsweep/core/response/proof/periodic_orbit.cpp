#include "rubsweep/core/response/proof/periodic_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/newton.hpp"

namespace rubsweep::response::proof {
namespace {

constexpr double close_enough =
    1e-2;  ///< return error, in (clearance, clearance omega), below which a proof is tried
/// relative to returns after fewer turns, and to the return at the last refusal
constexpr double much_closer = 0.1;
constexpr double much_later = 1.3;  ///< ratio of the run's turns to those at the last refusal

/// Largest difference of `count` numbers; stops at the first above `worst` and returns it.
double largest_difference(const double* a, const double* b, std::size_t count, double worst) {
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double difference = std::abs(a[i] - b[i]);
    if (difference > worst) return difference;
    largest = difference > largest ? difference : largest;
  }
  return largest;
}

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr numerics::NewtonLimits newton_limits{.iterations = 8, .free_iterations = 1, .growth = 0.5};
constexpr double closed = 1e-11;        ///< return error of a found orbit, in (clearance, clearance omega)
constexpr double nearly_closed = 1e-5;  ///< distance below which rough derivatives would cost a further step
constexpr double returns_early = 1e-7;  ///< return error at which fewer turns are the period
/// Largest multiplier at the transient for which Newton's iteration is tried. No proven orbit had a larger
/// multiplier there, nor one above 1 at a later iterate; a refused orbit is tried again later.
constexpr double hopeless_from_afar = 1.2;

double largest(const VectorXd& x) { return x.cwiseAbs().maxCoeff(); }

bool advance(const TurnMap& turn, VectorXd& x, MatrixXd* disturbances) {
  return turn({x.data(), static_cast<std::size_t>(x.size())}, disturbances) && x.allFinite();
}

struct Return {
  int order = 0;
  VectorXd defect;  ///< distance of the section from itself after `order` turns
  MatrixXd monodromy;
};

/// Return after `order` turns from x, or after a divisor of them if the return error is as small there.
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

  /// The last Newton step reduces the error to rounding.
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

/// Lists the sections and derivatives of the orbit turn by turn.
bool list_turns(const TurnMap& turn, VectorXd x, StableOrbit& orbit) {
  for (int k = 0; k < orbit.order; ++k) {
    orbit.sections.push_back(x);
    orbit.transitions.emplace_back(MatrixXd::Identity(x.size(), x.size()));
    if (!advance(turn, x, &orbit.transitions.back())) return false;
  }
  return true;
}

}  // namespace

PeriodSearch::PeriodSearch(std::size_t states, int largest_order)
    : states_(states),
      largest_(largest_order),
      kept_(2 * largest_order + 1),
      rows_(states * static_cast<std::size_t>(kept_)),
      tried_(static_cast<std::size_t>(largest_order) + 1, Tried{close_enough, 0}) {}

/// The section `ago` turns before the latest, ago < kept_.
const double* PeriodSearch::row(int ago) const {
  const int slot = newest_ >= ago ? newest_ - ago : newest_ - ago + kept_;
  return rows_.data() + static_cast<std::size_t>(slot) * states_;
}

const double* PeriodSearch::before(const double* row) const {
  return (row == rows_.data() ? rows_.data() + rows_.size() : row) - states_;
}

void PeriodSearch::add(std::span<const double> section, bool touched) {
  if (++newest_ == kept_) newest_ = 0;
  std::copy(section.begin(), section.end(),
            rows_.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(newest_) * states_));
  if (touched) last_touch_ = turns_;
  ++turns_;
}

/// Error of the return after `order` turns that ended `ago` turns ago; only approximate above `worst`.
double PeriodSearch::return_error(int order, double worst, int ago) const {
  return largest_difference(row(ago), row(ago + order), states_, worst);
}

std::optional<int> PeriodSearch::candidate() const {
  const int known = static_cast<int>(std::min<long>(largest_, turns_ - 1));
  if (last_touch_ < turns_ - known) return std::nullopt;  // too long without contact for any order
  const double* const last = row(0);
  const double* then = last;
  for (int n = 1; n <= known; ++n) {
    then = before(then);
    // The first number alone excludes most orders.
    const double error = largest_difference(last, then, states_, close_enough);
    if (error < close_enough && is_due(n, error) && closest(n, error) && contracts(n, error)) return n;
  }
  return std::nullopt;
}

/// Whether this return is much closer than those after any fewer turns.
bool PeriodSearch::closest(int order, double error) const {
  for (int n = 1; n < order; ++n) {
    if (!(error < much_closer * return_error(n, error / much_closer))) return false;
  }
  return true;
}

/// Whether there was contact before the return, and the return is either closer than at the last attempt or
/// much later.
bool PeriodSearch::is_due(int order, double error) const {
  const Tried& tried = tried_[static_cast<std::size_t>(order)];
  return last_touch_ >= turns_ - order && (error < tried.below || (tried.again > 0 && turns_ >= tried.again));
}

/// Whether the return one period earlier was farther. (Near an unstable orbit the returns of a transient
/// become less and less close.)
bool PeriodSearch::contracts(int order, double error) const {
  return turns_ > 2 * order && return_error(order, error, order) > error;
}

void PeriodSearch::refuse(int order) {
  Tried& tried = tried_[static_cast<std::size_t>(order)];
  tried.below = much_closer * return_error(order, std::numeric_limits<double>::infinity());
  tried.again = turns_ + std::max(8L, static_cast<long>((much_later - 1) * static_cast<double>(turns_)));
}

std::optional<StableOrbit> find_orbit(const TurnMap& turn, std::span<const double> section, int order,
                                      const TurnMap* roughly) {
  const VectorXd start =
      Eigen::Map<const VectorXd>(section.data(), static_cast<Eigen::Index>(section.size()));
  OrbitNewton found{
      .turn = turn, .roughly = roughly != nullptr ? *roughly : turn, .start = start, .order = order};
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
