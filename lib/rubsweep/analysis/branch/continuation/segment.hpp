#pragma once

#include <Eigen/Core>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

namespace rubsweep::branch::continuation {

/// Point of a curve, and its unit tangent.
struct PointAndTangent {
  const Eigen::VectorXd& at;
  const Eigen::VectorXd& tangent;
};

/// Guess for the point of a curve at the distance s along the tangent of `from`, by the cubic through both
/// points and tangents. The distance of the guess differs slightly from s, as the tangents turn. `length`:
/// length of the segment along the first tangent.
inline Eigen::VectorXd hermite_guess(const PointAndTangent& from, const PointAndTangent& to, double length,
                                     double s) {
  const double t = s / length, u = 1 - t;
  const Eigen::VectorXd guess = u * u * (1 + 2 * t) * from.at + t * t * (3 - 2 * t) * to.at +
                                length * t * u * (u * from.tangent - t * to.tangent);
  return guess + (s - from.tangent.dot(guess - from.at)) * from.tangent;
}

/// Thrown where the curve between two points is not continuous: a point between them is not found, or the
/// points belong to different branches.
struct NotContinuous {};

/// Piece of a solution curve between two points, parametrised by the distance s along the tangent of the
/// first point. A problem must have these functions:
/// - position_of(problem, point): its coordinates, in which lengths are measured;
/// - correct_between(problem, guess, from, to): Newton's iteration from a guess between two points, on the
///   plane across the tangent of `from`;
/// - completed(problem, correction, direction, arclength): the completed point, or nothing;
/// - nearest_image(problem, position, near): the position with its angles, if it has any, moved by whole
///   turns next to the angles of the point `near`.
template <class Problem, class Point>
class Segment {
 public:
  Segment(const Problem& problem, const Point& from, const Point& to)
      : problem_(problem),
        from_(from),
        to_(to),
        begin_(position_of(problem, from)),
        end_(position_of(problem, to)),
        length_(from.tangent.dot(end_ - begin_)) {}

  /// Distance of the end point; > 0 where `to` lies ahead of `from`.
  double length() const { return length_; }

  /// Completed point at 0 <= s <= length(). Empty where Newton's iteration does not find it.
  std::optional<Point> at(double s) const {
    if (s <= 0) return from_;
    if (s >= length_) return to_;
    const Eigen::VectorXd guess = hermite_guess({begin_, from_.tangent}, {end_, to_.tangent}, length_, s);
    const auto found = correct_between(problem_, guess, from_, to_);
    if (!found.converged) return std::nullopt;
    return completed(problem_, found, from_.tangent,
                     from_.arclength + s / length_ * (to_.arclength - from_.arclength));
  }

  /// Completed point at s; throws NotContinuous where it is not found.
  Point required_at(double s) const {
    auto point = at(s);
    if (!point) throw NotContinuous{};
    return std::move(*point);
  }

  /// Point of the segment at `position`; empty where the segment does not pass there.
  std::optional<Point> through(const Eigen::VectorXd& position) const {
    constexpr double same = 1e-7;
    const Eigen::VectorXd wanted = nearest_image(problem_, position, from_);
    const double ahead = from_.tangent.dot(wanted - begin_);
    if (ahead < 0 || ahead > length_ || (wanted - begin_).norm() > 1.5 * length_) return std::nullopt;
    auto there = at(ahead);
    if (!there || !((position_of(problem_, *there) - wanted).norm() < same)) return std::nullopt;
    return there;
  }

 private:
  const Problem& problem_;
  const Point &from_, &to_;
  Eigen::VectorXd begin_, end_;
  double length_;
};

/// Whether two points that enclose an event lie on the same branch.
template <class Problem, class Point>
bool continuous(const Problem& problem, const Point& a, const Point& b) {
  constexpr double near = 1e-6;
  return (position_of(problem, a) - position_of(problem, b)).norm() < near;
}

/// Width of the interval that encloses an event, in the coordinate along the curve.
inline constexpr double event_width = 1e-12;

/// Kind of event with its test function, which is smooth along a solution curve and zero at the event.
template <class Kind, class Point>
struct EventTest {
  Kind kind;
  std::function<double(const Point&)> value;
};

/// Distances along a segment that enclose an event.
struct Enclosure {
  double low = 0, high = 0;
};

/// Interval around the root of a test function; empty unless the function has opposite signs at the segment's
/// ends.
template <class Segment, class Value>
std::optional<Enclosure> root_on(const Segment& segment, const Value& value) {
  constexpr std::uintmax_t most_evaluations = 100;
  const double at_begin = value(segment.required_at(0)),
               at_end = value(segment.required_at(segment.length()));
  if ((at_begin < 0) == (at_end < 0)) return std::nullopt;
  std::uintmax_t evaluations = most_evaluations;
  const auto [low, high] = boost::math::tools::toms748_solve(
      [&](double s) { return value(segment.required_at(s)); }, 0.0, segment.length(), at_begin, at_end,
      [](double a, double b) { return std::abs(b - a) <= event_width; }, evaluations);
  return Enclosure{low, high};
}

/// Points on both sides of a change, close to it.
template <class Point>
struct EnclosedChange {
  Enclosure at;
  Point before, behind;
};

/// First change of a property, by bisection. `changed` is false at `before`, the point at `begin`, and true
/// at the end of the segment.
template <class Segment, class Point, class Changed>
EnclosedChange<Point> change_on(const Segment& segment, double begin, Point before, const Changed& changed) {
  double low = begin, high = segment.length();
  Point behind = segment.required_at(high);
  while (high - low > event_width) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    Point point = segment.required_at(middle);
    const bool is_changed = changed(point);
    (is_changed ? high : low) = middle;
    (is_changed ? behind : before) = std::move(point);
  }
  return {{low, high}, std::move(before), std::move(behind)};
}

}  // namespace rubsweep::branch::continuation
