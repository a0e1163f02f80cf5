#pragma once

#include <algorithm>

namespace rubsweep::branch::continuation {

/// Adaptive step length of pseudo-arclength continuation.
class StepControl {
 public:
  /// `options`: first_step, longest_step and shortest_step.
  template <class Options>
  explicit StepControl(const Options& options)
      : step_(options.first_step), longest_(options.longest_step), shortest_(options.shortest_step) {}

  double step() const { return step_; }

  /// Halves the step, as no point was found one step ahead; false where it becomes too short.
  bool shorten() {
    step_ /= 2;
    return step_ >= shortest_;
  }

  /// A correction farther from its guess than this may have found another branch, or another part of this
  /// one.
  bool is_far(double from_guess) const { return from_guess > 0.2 * step_; }

  /// `cosine`: of the angle between the tangents here and one step ahead.
  bool turns_sharply(double cosine) const { return cosine < 0.94 && step_ > 100 * shortest_; }

  /// Follows a step that Newton's iteration found as easily as this.
  void lengthen(double cosine, bool easily) {
    if (cosine > 0.985 && easily) step_ = std::min(longest_, 1.5 * step_);
  }

 private:
  double step_, longest_, shortest_;
};

}  // namespace rubsweep::branch::continuation
