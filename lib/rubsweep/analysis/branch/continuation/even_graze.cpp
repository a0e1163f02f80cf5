#include "rubsweep/analysis/branch/continuation/even_graze.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"

namespace rubsweep::branch::continuation {
namespace {

using Eigen::VectorXd;

constexpr double first_penetration = 1e-3, last_penetration = 4e-7;
constexpr int nodes_wanted = 7;
constexpr std::size_t extrapolated_from = 5;  ///< number of nodes
/// Largest penetration at which orbits on the other side of the graze are sought.
constexpr double other_side = 1e-6;

const orbits::EvenContact* even_at(const BranchPoint& point, int contact) {
  const auto found = std::ranges::find(point.facts.even, contact, &orbits::EvenContact::contact);
  return found == point.facts.even.end() ? nullptr : &*found;
}

double penetration(const orbits::OrbitProblem& problem, const Position& at, int contact) {
  return problem.penetration(parameter_of(problem, at), state_of(at), contact);
}

/// Slope of the penetration per unit of length along `tangent`.
double slope_along(const orbits::OrbitProblem& problem, const Position& at, const VectorXd& tangent,
                   int contact) {
  constexpr double h = 1e-6;
  return (penetration(problem, at + h * tangent, contact) - penetration(problem, at - h * tangent, contact)) /
         (2 * h);
}

/// Orbit of the branch near the graze. `at`: its position, then its distance along the start's tangent.
struct Node {
  double penetration = 0;
  VectorXd at;
};

/// Value at `to` of the polynomial in the penetration that passes through the last `count` nodes.
VectorXd extrapolated(const std::vector<Node>& nodes, std::size_t count, double to) {
  count = std::min(count, nodes.size());
  const std::size_t first = nodes.size() - count;
  VectorXd sum = VectorXd::Zero(nodes.front().at.size());
  for (std::size_t i = first; i < nodes.size(); ++i) {
    double weight = 1;
    for (std::size_t k = first; k < nodes.size(); ++k)
      if (k != i) weight *= (to - nodes[k].penetration) / (nodes[i].penetration - nodes[k].penetration);
    sum += weight * nodes[i].at;
  }
  return sum;
}

class EvenGrazeSearch {
 public:
  EvenGrazeSearch(const orbits::OrbitProblem& problem, const BranchPoint& here, int contact)
      : problem_(problem), here_(here), contact_(contact), begin_(position_of(problem, here)) {
    add(begin_, even_at(here, contact)->penetration);
    slope_ = slope_along(problem, begin_, here.tangent, contact);
  }

  /// Distance to the graze, estimated by the slope; <= 0 where the branch leads away from the graze.
  double expected() const { return -nodes_.front().penetration / slope_; }

  std::optional<EvenGraze> find(double farthest) {
    const double begin = std::min(first_penetration, 0.6 * std::abs(nodes_.front().penetration));
    if (begin < 2 * last_penetration) return std::nullopt;
    for (int i = 0; i < nodes_wanted; ++i) {
      const double share = static_cast<double>(i) / (nodes_wanted - 1);
      if (!approach(begin * std::pow(last_penetration / begin, share), farthest)) return std::nullopt;
      add_estimate();
    }
    auto before = completed(problem_, last_, here_.tangent, here_.arclength + distance(nodes_.back().at));
    if (!before || even_at(*before, contact_) == nullptr) return std::nullopt;
    EvenGraze graze{std::move(*before), {}, {}};
    const VectorXd root = extrapolated(nodes_, extrapolated_from, 0);
    const Position there = root.head(begin_.size());
    BranchPoint point = graze.before;
    point.parameter = parameter_of(problem_, there);
    if (point.parameter < problem_.low || point.parameter > problem_.high) return std::nullopt;
    point.state = state_of(there);
    point.arclength = here_.arclength + distance(root);
    graze.beyond = beyond(there, point.arclength);
    take_facts(graze.beyond, point);
    add_events(point, graze);
    return graze;
  }

 private:
  bool touches() const { return nodes_.front().penetration > 0; }

  static double distance(const VectorXd& node) { return node(node.size() - 1); }

  void add(const Position& at, double penetration) {
    Node node{penetration, VectorXd(at.size() + 1)};
    node.at << at, here_.tangent.dot(at - begin_);
    nodes_.push_back(std::move(node));
  }

  /// Adds the orbit on this side whose penetration is about `size`.
  bool approach(double size, double farthest) {
    const double wanted = std::copysign(size, nodes_.front().penetration);
    Position guess = begin_ + (wanted - nodes_.front().penetration) / slope_ * here_.tangent;
    if (nodes_.size() > 1) guess = extrapolated(nodes_, extrapolated_from, wanted).head(begin_.size());
    if (here_.tangent.dot(guess - begin_) > farthest) return false;
    // The orbits of a difference by the parameter must all lie on one side of the graze.
    const double step = std::clamp(size, 1e-8, usual_difference_step);
    last_ = correct(problem_, guess, here_.tangent, step);
    if (!last_.converged) return false;
    const Position at = polished(step);
    const double found = penetration(problem_, at, contact_);
    if (!(found / wanted > 0.1 && found / nodes_.back().penetration < 0.9)) return false;
    add(at, found);
    return true;
  }

  /// Position of the orbit after one more Newton step. A second extra step measures the effect of rounding.
  Position polished(double difference_step) {
    Position at = position_of(problem_, last_);
    const VectorXd step = next_step(problem_, last_.point, here_.tangent, difference_step);
    if (!step.allFinite()) return at;
    at += step;
    last_.point.parameter = parameter_of(problem_, at);
    last_.point.state = state_of(at);
    const VectorXd rest = next_step(problem_, last_.point, here_.tangent, difference_step);
    if (rest.allFinite()) rounding_ = std::max(rounding_, rest.norm());
    return at;
  }

  void add_estimate() {
    estimates_.push_back(
        parameter_of(problem_, extrapolated(nodes_, extrapolated_from, 0).head(begin_.size())));
  }

  bool is_beyond(const BranchPoint& point) const {
    const orbits::EvenContact* even = even_at(point, contact_);
    return even != nullptr && (even->penetration > 0) != touches() &&
           std::abs(even->penetration) < first_penetration;
  }

  /// Point with the direction of its tangent chosen so that the penetration keeps changing in the same sense.
  BranchPoint led_away(BranchPoint point) const {
    const double slope = slope_along(problem_, position_of(problem_, point), point.tangent, contact_);
    return (slope > 0) == touches() ? turned_about(std::move(point)) : point;
  }

  std::optional<BranchPoint> beyond(const Position& corner, double arclength) const {
    auto point = beyond_by_tangent(corner);
    if (!point) point = beyond_by_settling(corner);
    if (!point) return std::nullopt;
    point = led_away(std::move(*point));
    point->arclength = arclength + (position_of(problem_, *point) - corner).norm();
    return point;
  }

  /// Finds an orbit on the other side of the corner. Newton's iteration starts from a point on the tangent of
  /// that side. This tangent is computed at a state extrapolated to that side, where the contact is open, or
  /// closed, along the whole orbit.
  std::optional<BranchPoint> beyond_by_tangent(const Position& corner) const {
    BranchPoint there = here_;
    there.parameter = parameter_of(problem_, corner);
    there.state = state_of(
        extrapolated(nodes_, extrapolated_from, touches() ? -other_side : other_side).head(begin_.size()));
    VectorXd image = there.state;
    if (problem_.returns(there.parameter, image, &there.monodromy) != orbits::Evaluation::ok ||
        !complete(problem_, here_.tangent, there))
      return std::nullopt;
    const double slope = slope_along(problem_, corner, there.tangent, contact_);
    if ((slope > 0) == touches()) there.tangent = -there.tangent;
    for (double size = other_side; size >= last_penetration / 4; size /= 4) {
      const double length = size / std::abs(slope);
      if (!(length < 1)) continue;
      const Position guess = corner + length * there.tangent;
      Correction found = correct(problem_, guess, there.tangent, size / 10);
      if (!found.converged || (position_of(problem_, found) - guess).norm() > length) continue;
      auto point = completed(problem_, std::move(found), there.tangent, 0);
      if (point && is_beyond(*point)) return point;
    }
    return std::nullopt;
  }

  /// Orbit behind the corner, found by simulation from the corner's state at a slightly different parameter.
  std::optional<BranchPoint> beyond_by_settling(const Position& corner) const {
    constexpr int returns = 300;
    for (double away = other_side; away >= last_penetration / 4; away /= 4) {
      for (const double side : {away, -away}) {
        const double parameter = parameter_of(problem_, corner) + side * problem_.parameter_scale;
        VectorXd state = state_of(corner);
        for (int i = 0; i < returns && state.allFinite(); ++i)
          if (problem_.returns(parameter, state, nullptr) != orbits::Evaluation::ok) break;
        auto point = state.allFinite() ? orbit_from(problem_, state, parameter) : std::nullopt;
        if (point && is_beyond(*point)) return point;
      }
    }
    return std::nullopt;
  }

  /// Sets the facts at the graze itself. Whether the orbit touches there is taken from the orbit beyond it.
  void take_facts(const std::optional<BranchPoint>& beyond, BranchPoint& point) const {
    if (auto facts = problem_.facts(point.parameter, point.state)) point.facts = std::move(*facts);
    if (beyond) {
      const orbits::OrbitFacts here = std::exchange(point.facts, beyond->facts);
      point.facts.amplitude_m = here.amplitude_m;
      point.facts.peak_displacement_m = here.peak_displacement_m;
      point.facts.peak_contact_force_n = here.peak_contact_force_n;
      point.monodromy = beyond->monodromy;
      point.multipliers = beyond->multipliers;
      point.unstable = beyond->unstable;
      point.tangent = beyond->tangent;
      point.branching = beyond->branching;
    } else if (point.facts.even.size() == 1 && point.facts.switches.empty()) {
      point.facts.touched = !touches();
      point.facts.contact_fraction = touches() ? 0 : 1;
    }
  }

  /// Error of the parameter: difference of the last estimates, plus the effect of rounding on the nodes.
  double parameter_error(double parameter_slope) const {
    double error = std::numeric_limits<double>::epsilon() * std::abs(estimates_.back());
    for (std::size_t i = estimates_.size() - 2; i < estimates_.size(); ++i)
      error = std::max(error, 2 * std::abs(estimates_[i] - estimates_[i - 1]));
    const double penetrations = std::sqrt(static_cast<double>(here_.state.size()));
    return error + rounding_ * (problem_.parameter_scale + penetrations * std::abs(parameter_slope));
  }

  void add_events(const BranchPoint& point, EvenGraze& graze) const {
    constexpr double same_place = 1e-9;
    const double slope = (parameter_of(problem_, nodes_.back().at.head(begin_.size())) - point.parameter) /
                         nodes_.back().penetration;
    for (const orbits::EvenContact& even : graze.before.facts.even) {
      const double here =
          even.contact == contact_ ? 0 : penetration(problem_, position_of(problem_, point), even.contact);
      if (std::abs(here) > same_place) continue;
      BranchEvent event{EventKind::graze, point, parameter_error(slope), {}};
      event.parameter_error += std::abs(slope) * (even.spread / 2 + std::abs(here));
      event.change = orbits::SequenceChange{
          .kind = orbits::SequenceChange::Kind::even, .contact = even.contact, .to = even.touching};
      event.detail = orbits::describe(*event.change) + (touches() ? " disappears" : " appears");
      graze.events.push_back(std::move(event));
    }
  }

  const orbits::OrbitProblem& problem_;
  const BranchPoint& here_;
  int contact_;
  Position begin_;
  double slope_ = 0;
  std::vector<Node> nodes_;
  std::vector<double> estimates_;
  Correction last_;
  double rounding_ = 0;  ///< error of the last orbit's position
};

}  // namespace

std::optional<EvenGraze> even_graze_ahead(const orbits::OrbitProblem& problem, const BranchPoint& here,
                                          double step) {
  if (!problem.penetration || !problem.facts) return std::nullopt;
  constexpr double reach = 1.5;  ///< number of steps; the next step must not end where rounding dominates
  std::optional<EvenGrazeSearch> nearest;
  for (const orbits::EvenContact& even : here.facts.even) {
    if (std::abs(even.penetration) < last_penetration) continue;
    EvenGrazeSearch search(problem, here, even.contact);
    const double expected = search.expected();
    if (!(expected > 0 && expected < reach * step)) continue;
    if (!nearest || expected < nearest->expected()) nearest.emplace(std::move(search));
  }
  return nearest ? nearest->find(2 * reach * step) : std::nullopt;
}

bool even_contact_changes(const BranchPoint& a, const BranchPoint& b) {
  return std::ranges::any_of(a.facts.even, [&](const orbits::EvenContact& here) {
    const orbits::EvenContact* there = even_at(b, here.contact);
    return there != nullptr && (there->penetration > 0) != (here.penetration > 0);
  });
}

}  // namespace rubsweep::branch::continuation
