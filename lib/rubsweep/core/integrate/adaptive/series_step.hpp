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
/// are accurate: to a share of the tolerance, at least to 1e-12. Steps that have no such series, or whose
/// friction is stiff, are made by the stepper of the options.
template <int N>
class SeriesStep final : public StepMethod {
 public:
  using Law = law::Dynamics<N, false>;

  /// `law` must outlive this.
  SeriesStep(const Law& law, const run::SolverOptions& options)
      : law_(law),
        motion_(law.system(), std::clamp(options.relative_tolerance * share_of_tolerance,
                                         taylor::rounding_of_series, least_accuracy)),
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
    return step.knows_modes &&
           tangents_.pass(motion_, time_at(step, end_phase), accuracy, remembering, vectors);
  }

  void restart() override { other_->restart(); }
  long implicit_steps() const override { return other_->implicit_steps(); }

 private:
  /// Accuracy of the series over the tolerance, and its largest value.
  static constexpr double share_of_tolerance = 1e-4, least_accuracy = 1e-12;
  static constexpr double shortest_rad = 1e-13;

  double time_at(const Step& step, double phase) const {
    return phase >= end_phase_ ? end_ : motion_.time().parameter_at(phase - step.start_phase, end_);
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
      step.ending = Crossing{.phase = step.end_phase, .contact = *event.contact, .next = event.next};
    return true;
  }

  const Law& law_;
  taylor::RegularExpansion<N> motion_;
  taylor::RegularTangents<N> tangents_;
  std::unique_ptr<StepMethod> other_;
  double stiff_above_;
  double end_ = 0, end_phase_ = 0;  ///< end of the last step by series, in their time and as a phase
};

}  // namespace rubsweep::integrate::adaptive
