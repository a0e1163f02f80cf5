#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "rubsweep/core/integrate/adaptive/step_method.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/taylor/regular_expansion.hpp"
#include "rubsweep/core/integrate/taylor/regular_tangents.hpp"
#include "rubsweep/core/integrate/taylor/series_options.hpp"

namespace rubsweep::integrate::adaptive {

/// Method that makes steps by power series of a regular time (taylor::RegularExpansion), each as long as they
/// are accurate: to a thousandth of the tolerance, at least to 1e-9. Steps that have no such series, or whose
/// friction is stiff, are made by the stepper of the options.
template <int N>
class SeriesStep final : public StepMethod {
 public:
  using Law = law::Dynamics<N, false>;

  /// `law` must outlive this.
  SeriesStep(const Law& law, const run::SolverOptions& options)
      : law_(law),
        motion_(law.system(), accuracy_of(options)),
        rest_(law.system(), accuracy_of(options)),
        tangents_(law.system()),
        other_(make_step_method(options)),
        stiff_above_(run::stiff_friction_ratio(options.relative_tolerance)) {}

  bool try_step(RightHandSide& law, Step& step, double& size) override {
    step.knows_modes = go_on(step);
    if (!step.knows_modes) return other_->try_step(law, step, size);
    law(step.end, step.end_rate, step.end_phase);
    return true;
  }

  void state_at(RightHandSide& law, const Step& step, double phase, State& out) override {
    if (!step.knows_modes) return other_->state_at(law, step, phase, out);
    motion_.put_state(time_at(step, phase), out.data());
  }

  bool move_tangents(const Step& step, double end_phase, const std::vector<std::size_t>& remembering,
                     double accuracy, Eigen::Map<Eigen::MatrixXd>& vectors) override {
    if (!step.knows_modes || motion_.sticks()) return false;
    double s = time_at(step, end_phase), phase_rad = step.start_phase;
    taylor::RegularExpansion<N>* motion = &motion_;
    kept_ = vectors;
    // Series of the vectors may converge more slowly than those of the motion: halves, and a new expansion.
    for (int part = 0; part < most_parts; ++part) {
      double until = s;
      int tries = 0;
      for (; tries < most_parts && !tangents_.pass(*motion, until, accuracy, remembering, vectors); ++tries)
        until /= 2;
      if (tries == most_parts) break;
      phase_rad += motion->time().phase_after(until);
      if (until == s && motion == &motion_) return true;
      if (phase_rad >= end_phase - shortest_rad) return true;
      if (!expand_rest(*motion, until, phase_rad)) break;
      motion = &rest_;
      s = rest_.time().parameter_at(end_phase - phase_rad, rest_.converged());
    }
    vectors = kept_;
    return false;
  }

  void restart() override { other_->restart(); }
  long implicit_steps() const override { return other_->implicit_steps(); }

 private:
  /// Accuracy of the series over the tolerance, and its largest value.
  static constexpr double share_of_tolerance = 1e-3, least_accuracy = 1e-9;
  static constexpr double shortest_rad = 1e-13;
  static constexpr int most_parts = 6;  ///< Parts into which tangent vectors divide a step.

  static double accuracy_of(const run::SolverOptions& options) {
    return std::clamp(options.relative_tolerance * share_of_tolerance, taylor::rounding_of_series,
                      least_accuracy);
  }

  double time_at(const Step& step, double phase) const {
    return phase >= end_phase_ ? end_ : motion_.time().parameter_at(phase - step.start_phase, end_);
  }

  /// Expands the rest of the step of `motion` from `s`, the phase `phase_rad`, on.
  bool expand_rest(const taylor::RegularExpansion<N>& motion, double s, double phase_rad) {
    state_.resize(static_cast<std::size_t>(2 * law_.system().coordinates()));
    rate_.resize(state_.size());
    motion.put_state(s, state_.data());
    law_(state_, rate_, phase_rad);
    return rest_.expand(state_, rate_, phase_rad, law_);
  }

  bool go_on(Step& step) {
    step.ending.reset();
    if (law_.friction_ratio(step.start) > stiff_above_ ||
        !motion_.expand(step.start, step.start_rate, step.start_phase, law_))
      return false;
    end_ = motion_.converged();
    typename taylor::RegularExpansion<N>::Event event;
    if (!motion_.find_event(end_, event)) return false;
    const double left = step.latest_phase - step.start_phase, advance = motion_.time().phase_after(end_);
    const double most = std::min(left, motion_.most_rad(end_));
    if (advance > most) end_ = motion_.time().parameter_at(most, end_);
    const double made = std::min(advance, most);
    if (!(made > shortest_rad)) return false;
    motion_.put_state(end_, step.end.data());
    step.end_phase = end_phase_ = made < left ? step.start_phase + made : step.latest_phase;
    if (event.contact && advance <= most)
      step.ending = Crossing{
          .phase = step.end_phase,
          .contact = *event.contact,
          .next = event.next,
          .event = event.slip == contact::Slip::sticking ? Crossing::Event::mode : Crossing::Event::release,
          .slip = event.slip};
    return true;
  }

  const Law& law_;
  taylor::RegularExpansion<N> motion_, rest_;  ///< rest_: later parts of a step, for tangent vectors
  taylor::RegularTangents<N> tangents_;
  std::unique_ptr<StepMethod> other_;
  double stiff_above_;
  State state_, rate_;
  Eigen::MatrixXd kept_;
  double end_ = 0, end_phase_ = 0;  ///< end of the last step by series, in their time and as a phase
};

}  // namespace rubsweep::integrate::adaptive
