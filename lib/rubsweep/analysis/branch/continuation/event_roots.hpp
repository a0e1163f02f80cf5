#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

namespace rubsweep::branch::continuation {

/// Events are enclosed to this, in the coordinate along the curve.
inline constexpr double event_width = 1e-12;

/// Kind of event with its test function: smooth along a solution curve, and zero where the event is.
template <class Kind, class Point>
struct EventTest {
  Kind kind;
  std::function<double(const Point&)> value;
};

/// Distances along a segment that enclose an event.
struct Enclosure {
  double low = 0, high = 0;
};

/// Root of a test function that has opposite signs at both ends of a segment; empty where it has not.
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

/// Points on both sides of a change.
template <class Point>
struct EnclosedChange {
  Enclosure at;
  Point before, behind;
};

/// First change of a property, by bisection: `changed` is false at `begin` with the point `before`, and true
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
