#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "rubsweep/branch/branch_point.hpp"

namespace rubsweep::branch {

/// One side of a branch, or of a curve, as pseudo-arclength continuation adds point after point: how long the
/// next step is, and whether there is one. `Half` is HalfBranch or HalfCurve.
template <class Half>
class GrowingHalf {
 public:
  /// `options`: first_step, longest_step, shortest_step and most_points.
  template <class Point, class Options>
  GrowingHalf(Point start, const Options& options)
      : step_(options.first_step),
        longest_(options.longest_step),
        shortest_(options.shortest_step),
        most_points_(static_cast<std::size_t>(options.most_points)) {
    half.points.push_back(std::move(start));
  }

  /// Calls `make_step` until the side has ended.
  template <class MakeStep>
  void grow(const MakeStep& make_step) {
    while (!ended_) {
      if (half.points.size() >= most_points_) {
        end(Ending::point_limit);
      } else {
        make_step();
      }
    }
  }

  const auto& here() const { return half.points.back(); }
  double step() const { return step_; }
  bool ended() const { return ended_; }

  void end(Ending ending) {
    half.ending = ending;
    ended_ = true;
  }

  /// No point was found one step ahead: half of it, until there is no half.
  void shorten(Ending otherwise) {
    step_ /= 2;
    if (step_ < shortest_) end(otherwise);
  }

  /// Farther from the guess than this it may be another branch, or another part of this one.
  bool is_far(double from_guess) const { return from_guess > 0.2 * step_; }

  /// `cosine`: of the angle between the tangents here and one step ahead.
  bool turns_sharply(double cosine) const { return cosine < 0.94 && step_ > 100 * shortest_; }

  /// After a step that Newton's iteration found as easily as this.
  void lengthen(double cosine, bool easily) {
    if (cosine > 0.985 && easily) step_ = std::min(longest_, 1.5 * step_);
  }

  Half half;

 private:
  double step_, longest_, shortest_;
  std::size_t most_points_;
  bool ended_ = false;
};

/// Points, or what happens at points, of the side that was followed backward: by ascending arclength, which
/// is below 0 there. `point_in` has the point of an element.
template <class Element, class PointIn>
void turn_about(std::vector<Element>& elements, const PointIn& point_in) {
  for (Element& element : elements) point_in(element).arclength = -point_in(element).arclength;
  std::ranges::reverse(elements);
}

/// Both sides of a branch, or of a curve, as one: the start, which both have, once.
template <class Element>
std::vector<Element> joined(std::vector<Element> backward, std::vector<Element> forward) {
  std::ranges::move(forward, std::back_inserter(backward));
  return backward;
}

}  // namespace rubsweep::branch
