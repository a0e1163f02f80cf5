#include "rubsweep/analysis/branch/continuation/margins.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>

#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"
#include "rubsweep/analysis/branch/orbits/multipliers.hpp"

namespace rubsweep::branch::continuation {
namespace {

using contact::Mode;
using integrate::run::ModeSwitch;

constexpr double near_zero = 0.5;  ///< largest dip, as a share of the value at the end nearer to zero

/// Cubic a + b t + c t^2 + d t^3 for 0 <= t <= 1.
struct Cubic {
  double a = 0, b = 0, c = 0, d = 0;

  double at(double t) const { return a + t * (b + t * (c + t * d)); }
  double end() const { return a + b + c + d; }
};

struct Extrema {
  std::optional<double> lowest, highest;  ///< places of the local minimum and maximum inside the interval
};

Extrema extrema_of(const Cubic& f) {
  Extrema found;
  const auto add = [&](double t) {
    if (!(t > 0 && t < 1)) return;
    (f.c + 3 * f.d * t > 0 ? found.lowest : found.highest) = t;
  };
  const double discriminant = f.c * f.c - 3 * f.b * f.d;
  if (!(discriminant > 0)) return found;
  // Both roots of b + 2 c t + 3 d t^2, without cancellation.
  const double q = -(f.c + std::copysign(std::sqrt(discriminant), f.c));
  if (q != 0) add(f.b / q);
  if (f.d != 0) add(q / (3 * f.d));
  return found;
}

/// Place of a dip through which a function that is positive at the beginning may have two roots, although the
/// signs at its ends do not show them.
std::optional<double> dip_of(const Cubic& f) {
  const Extrema extrema = extrema_of(f);
  if (!extrema.lowest) return std::nullopt;
  const double lowest = f.at(*extrema.lowest);
  if (f.end() > 0) {
    if (lowest < near_zero * std::min(f.a, f.end())) return extrema.lowest;
    return std::nullopt;
  }
  // The function becomes negative, returns to positive values and becomes negative again.
  const bool comes_back =
      extrema.highest && *extrema.highest > *extrema.lowest && f.at(*extrema.highest) > near_zero * f.end();
  if (comes_back && lowest < near_zero * f.a) return extrema.lowest;
  return std::nullopt;
}

std::optional<double> dip_of_signed(Cubic f) {
  if (f.a < 0) f = {-f.a, -f.b, -f.c, -f.d};
  return dip_of(f);
}

double period_of(const orbits::OrbitProblem& problem) { return 2 * std::numbers::pi * problem.order; }

/// Stretch from the change `begin` to the change `end`, which follows it in the closed sequence.
Margin stretch_between(const ModeSwitch& begin, const ModeSwitch& end, double period_rad) {
  double duration_rad = end.phase_rad - begin.phase_rad;
  if (duration_rad <= 0) duration_rad += period_rad;
  return {Margin::Kind::stretch,      begin.contact, begin.from, begin.to, begin.phase_rad,
          duration_rad * duration_rad};
}

/// Adds the hits, flights and returns to a mode of one contact, whose changes are `changes`.
void add_stretches(const std::vector<ModeSwitch>& changes, double period_rad, std::vector<Margin>& margins) {
  const std::size_t count = changes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const ModeSwitch &begin = changes[i], &next = changes[(i + 1) % count];
    if (count > 1 && (begin.to == Mode::open || begin.from == next.to))
      margins.push_back(stretch_between(begin, next, period_rad));
    if (begin.from != Mode::open || begin.from == next.to) continue;
    for (std::size_t k = 2; k <= count; ++k) {
      if (changes[(i + k) % count].to != Mode::open) continue;
      margins.push_back(stretch_between(begin, changes[(i + k) % count], period_rad));
      break;
    }
  }
}

std::vector<Margin> margins_at(const std::vector<orbits::Approach>& approaches,
                               const std::vector<ModeSwitch>& switches, double period_rad) {
  std::vector<Margin> margins;
  margins.reserve(approaches.size());
  for (const orbits::Approach& approach : approaches)
    margins.push_back({Margin::Kind::approach, approach.contact, approach.from, approach.to,
                       approach.phase_rad, approach.distance});
  int contacts = 0;
  for (const ModeSwitch& change : switches) contacts = std::max(contacts, change.contact + 1);
  for (int contact = 0; contact < contacts; ++contact) {
    std::vector<ModeSwitch> changes;
    std::ranges::copy_if(switches, std::back_inserter(changes),
                         [&](const ModeSwitch& change) { return change.contact == contact; });
    add_stretches(changes, period_rad, margins);
  }
  return margins;
}

double distance_of_phases(double a, double b, double period_rad) {
  return std::abs(std::remainder(a - b, period_rad));
}

/// Margin of the same kind that is nearest in phase; null where there is no other of this kind.
const Margin* partner(const Margin& one, const std::vector<Margin>& all, double period_rad) {
  const Margin* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Margin& other : all) {
    if (!one.is_like(other)) continue;
    const double distance = distance_of_phases(one.phase_rad, other.phase_rad, period_rad);
    if (distance >= least) continue;
    least = distance;
    nearest = &other;
  }
  return nearest;
}

}  // namespace

MultiplierTests tests_of_multipliers(const Eigen::VectorXcd& multipliers) {
  return {orbits::unit_test(multipliers), orbits::doubling_test(multipliers),
          orbits::torus_test(multipliers)};
}

MultiplierTests multiplier_slopes(const orbits::OrbitProblem& problem, const BranchPoint& point) {
  constexpr double along = 1e-5;  ///< far above the noise of a turn, 1e-13, and far below any step
  const MultiplierTests here = tests_of_multipliers(point.multipliers);
  for (const double h : {along, -along}) {
    const Position at = position_of(problem, point) + h * point.tangent;
    Eigen::VectorXd state = state_of(at);
    Eigen::MatrixXd monodromy;
    if (problem.returns(parameter_of(problem, at), state, &monodromy) != orbits::Evaluation::ok) continue;
    if (!monodromy.allFinite()) continue;
    const MultiplierTests there = tests_of_multipliers(orbits::multipliers_of(monodromy));
    return {(there.unit - here.unit) / h, (there.doubling - here.doubling) / h,
            (there.torus - here.torus) / h};
  }
  return {};
}

std::optional<double> dip_of_cubic(const StepEnds& ends, double length) {
  const double rise = ends.end - ends.begin, out = length * ends.begin_slope, in = length * ends.end_slope;
  return dip_of_signed({ends.begin, out, 3 * rise - 2 * out - in, out + in - 2 * rise});
}

std::optional<double> dip_of_quadratic(double begin, double end, double mean) {
  return dip_of_signed({begin, 6 * mean - 4 * begin - 2 * end, 3 * (begin + end - 2 * mean), 0});
}

std::vector<Margin> margins_of(const orbits::OrbitProblem& problem, const BranchPoint& point) {
  constexpr double along = 1e-5;  ///< step as for the slopes of multipliers
  if (!problem.passages) return {};
  const double period_rad = period_of(problem);
  const auto here = problem.passages(point.parameter, point.state);
  if (!here) return {};
  std::vector<Margin> margins = margins_at(here->approaches, here->switches, period_rad);
  if (margins.empty()) return margins;
  for (const double h : {along, -along}) {
    const Position at = position_of(problem, point) + h * point.tangent;
    const auto beside = problem.passages(parameter_of(problem, at), state_of(at));
    if (!beside) continue;
    const auto others = margins_at(beside->approaches, beside->switches, period_rad);
    std::erase_if(margins, [&](Margin& margin) {
      const Margin* other = partner(margin, others, period_rad);
      if (other != nullptr) margin.slope = (other->value - margin.value) / h;
      return other == nullptr;
    });
    return margins;
  }
  return {};
}

std::optional<double> share_of_dip(const std::vector<Margin>& from, const std::vector<Margin>& to,
                                   double period_rad, double length, double cosine) {
  for (const Margin& begin : from) {
    const Margin* end = partner(begin, to, period_rad);
    if (end == nullptr || partner(*end, from, period_rad) != &begin) continue;
    if (const auto share = dip_of_cubic({begin.value, end->value, begin.slope, end->slope / cosine}, length))
      return share;
  }
  return std::nullopt;
}

}  // namespace rubsweep::branch::continuation
