#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/continuation/segment.hpp"

namespace rubsweep::branch::continuation {

/// Adaptive step length of pseudo-arclength continuation.
class StepControl {
 public:
  /// `options`: first_step, longest_step and shortest_step.
  template <class Options>
  explicit StepControl(const Options& options)
      : step_(options.first_step), longest_(options.longest_step), shortest_(options.shortest_step) {}

  double step() const { return step_; }

  /// Halves the step after a failure; false where it becomes too short.
  bool shorten() {
    step_ /= 2;
    return step_ >= shortest_;
  }

  /// Whether a correction is so far from its guess that it may lie on another branch, or on a distant part of
  /// this branch.
  bool is_far(double from_guess) const { return from_guess > 0.2 * step_; }

  /// Whether the curve turns too much in one step. `cosine`: cosine of the angle between the tangents at both
  /// ends of the step.
  bool turns_sharply(double cosine) const { return cosine < 0.94 && step_ > 100 * shortest_; }

  /// Lengthens the step after a success. `easily`: Newton's iteration needed few iterations.
  void lengthen(double cosine, bool easily) {
    if (cosine > 0.985 && easily) step_ = std::min(longest_, 1.5 * step_);
  }

 private:
  double step_, longest_, shortest_;
};

/// Pseudo-arclength continuation: predictor along the tangent, Newton's iteration across it as corrector,
/// adaptive steps, and a search for events in every step. A `Task` defines what is continued and where it
/// ends:
/// - Problem, Point, Event, Half (points, events, ending), Correction: its types;
/// - problem(): see Segment;
/// - easy_iterations: the step grows if Newton's iteration needs no more iterations than this number;
/// - holds(correction): whether a correction lies in the range of the parameters;
/// - correct_at_edge(here, correction): Newton's iteration on the edge of this range, which the step to
///   `correction` has crossed; empty where `here` is on the edge already;
/// - refuses(here, next): reason why `next` cannot be the point after `here`, or empty;
/// - prepare(next): adds the data that the search for events needs;
/// - events_between(here, next): events by ascending arclength; empty where no continuous curve connects the
///   two points;
/// - ending_at(start, event): reason why the curve ends at an event, or empty;
/// - images(point): positions of the same solution, one for each turn of its period;
/// - corner_ahead(here, step), optional: corner of the curve within about a step, as in EvenGraze, or empty.
template <class Task>
class Continuation {
 public:
  using Point = typename Task::Point;
  using Half = typename Task::Half;

  template <class Options>
  Continuation(const Task& task, const Point& start, const Options& options)
      : task_(task),
        steps_(options),
        most_points_(static_cast<std::size_t>(options.most_points)),
        images_of_start_(task.images(start)) {
    half_.points.push_back(start);
  }

  Half run() {
    while (!ended_) {
      if (half_.points.size() >= most_points_) {
        end(Ending::point_limit);
      } else {
        make_step();
      }
    }
    return std::move(half_);
  }

 private:
  using Correction = typename Task::Correction;

  const Point& here() const { return half_.points.back(); }

  template <class PointOrCorrection>
  Eigen::VectorXd position(const PointOrCorrection& of) const {
    return position_of(task_.problem(), of);
  }

  void end(Ending ending) {
    half_.ending = ending;
    ended_ = true;
  }

  void shorten(Ending otherwise) {
    if (!steps_.shorten()) end(otherwise);
  }

  void make_step() {
    if (turns_corner()) return;
    const Eigen::VectorXd guess = position(here()) + steps_.step() * here().tangent;
    const Correction found = correct_between(task_.problem(), guess, here(), here());
    if (found.evaluation == orbits::Evaluation::infeasible) return shorten(Ending::infeasible);
    if (found.evaluation == orbits::Evaluation::failed) return shorten(Ending::failed);
    if (found.singular) return shorten(Ending::singular);
    if (!found.converged || steps_.is_far((position(found) - guess).norm()))
      return shorten(Ending::step_too_small);
    if (!task_.holds(found)) return step_to_edge(found);
    auto next = completed(task_.problem(), found, here().tangent, here().arclength + steps_.step());
    if (!next) return shorten(Ending::singular);
    const double turn = next->tangent.dot(here().tangent);
    if (steps_.turns_sharply(turn)) return shorten(Ending::step_too_small);
    if (take(std::move(*next))) steps_.lengthen(turn, found.iterations <= Task::easy_iterations);
  }

  /// Continues around a corner within the step, or ends there. False where there is no corner.
  bool turns_corner() {
    if constexpr (requires { task_.corner_ahead(here(), steps_.step()); }) {
      auto corner = task_.corner_ahead(here(), steps_.step());
      if (!corner || is_closed_by(corner->before)) return ended_;
      auto events = task_.events_between(here(), corner->before);
      if (!events) return false;
      std::ranges::move(corner->events, std::back_inserter(*events));
      if (add_events(std::move(*events))) return true;
      half_.points.push_back(std::move(corner->beyond ? *corner->beyond : corner->events.front().point));
      if (!corner->beyond) end(Ending::singular);
      return true;
    }
    return false;
  }

  void step_to_edge(const Correction& beyond) {
    const std::optional<Correction> found = task_.correct_at_edge(here(), beyond);
    if (!found) return end(Ending::left_range);
    if (!found->converged) return shorten(Ending::step_too_small);
    const double length = here().tangent.dot(position(*found) - position(here()));
    if (!(length > 0) || length > 2 * steps_.step()) return shorten(Ending::step_too_small);
    auto last = completed(task_.problem(), *found, here().tangent, here().arclength + length);
    if (!last) return shorten(Ending::step_too_small);
    if (take(std::move(*last)) && !ended_) end(Ending::left_range);
  }

  /// Accepts `next` as the next point. Where `next` does not follow `here`, shortens the step and returns
  /// false.
  bool take(Point next) {
    if (const std::optional<Ending> refusal = task_.refuses(here(), next)) {
      shorten(*refusal);
      return false;
    }
    if (is_closed_by(next)) return true;
    task_.prepare(next);
    auto events = task_.events_between(here(), next);
    if (!events) {
      shorten(Ending::step_too_small);
      return false;
    }
    if (!add_events(std::move(*events))) half_.points.push_back(std::move(next));
    return true;
  }

  /// Adds the events up to the first one that ends the curve. Returns whether an event ends it.
  template <class Events>
  bool add_events(Events events) {
    for (auto& event : events) {
      half_.events.push_back(std::move(event));
      if (ends_at_last_event()) return true;
    }
    return false;
  }

  /// Whether the curve ends at the last event, whose point then becomes the last point.
  bool ends_at_last_event() {
    const auto ending = task_.ending_at(half_.points.front(), half_.events.back());
    if (!ending) return false;
    half_.points.push_back(half_.events.back().point);
    end(*ending);
    return true;
  }

  /// Whether the start lies between `here` and `next`; the curve is then closed and ends there.
  bool is_closed_by(const Point& next) {
    if (half_.points.size() < 3) return false;
    const Segment segment(task_.problem(), here(), next);
    for (const Eigen::VectorXd& start : images_of_start_) {
      auto there = segment.through(start);
      if (!there) continue;
      auto events = task_.events_between(here(), *there);
      if (!events) continue;
      std::ranges::move(*events, std::back_inserter(half_.events));
      half_.points.push_back(std::move(*there));
      end(Ending::closed);
      return true;
    }
    return false;
  }

  const Task& task_;
  StepControl steps_;
  std::size_t most_points_;
  std::vector<Eigen::VectorXd> images_of_start_;
  Half half_;
  bool ended_ = false;
};

/// Curve followed in both directions: points and events by ascending arclength.
template <class Half>
struct BothWays {
  Half all;  ///< `ending`: ending at its last point
  Ending backward = Ending::left_range;
};

/// `half` in reverse order with negative arclengths, without the start, which is the first point of the other
/// half.
template <class Half>
Half reversed(Half half) {
  half.points.erase(half.points.begin());
  const auto reverse = [](auto& elements, const auto& point_in) {
    for (auto& element : elements) {
      auto& point = point_in(element);
      point = turned_about(std::move(point));
      point.arclength = -point.arclength;
    }
    std::ranges::reverse(elements);
  };
  reverse(
      half.points, [](auto& point) -> auto& { return point; });
  reverse(
      half.events, [](auto& event) -> auto& { return event.point; });
  return half;
}

/// Continues from `start` in both directions; a closed curve is followed in one direction.
/// turned_about(point) is the point with its tangent reversed.
template <class Task, class Options>
BothWays<typename Task::Half> continue_both_ways(const Task& task, const typename Task::Point& start,
                                                 const Options& options) {
  auto forward = Continuation<Task>(task, start, options).run();
  if (forward.ending == Ending::closed) return {std::move(forward), Ending::closed};
  auto all = reversed(Continuation<Task>(task, turned_about(start), options).run());
  const Ending backward = std::exchange(all.ending, forward.ending);
  std::ranges::move(forward.points, std::back_inserter(all.points));
  std::ranges::move(forward.events, std::back_inserter(all.events));
  return {std::move(all), backward};
}

}  // namespace rubsweep::branch::continuation
