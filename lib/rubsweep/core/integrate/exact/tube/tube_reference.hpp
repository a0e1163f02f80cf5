#pragma once

#include <memory>
#include <span>
#include <vector>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/integrate/exact/exact_motion.hpp"
#include "rubsweep/core/integrate/exact/modes/joint_mode.hpp"
#include "rubsweep/core/integrate/exact/slip_watch.hpp"
#include "rubsweep/core/integrate/exact/tube/tube_spread.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"

namespace rubsweep::integrate::exact::tube {

/// Reference motion of a tube, with the disturbances that it carries and their projections onto guards and
/// slips.
template <int N>
class TubeReference {
 public:
  using State = typename ExactMotion<N>::State;
  using Spread = TurnTube::Spread;
  using Seen = modes::ModalSums;

  TubeReference(const scene::Scene& scene, std::shared_ptr<modes::MachineModes<N>> modes)
      : motion_(scene, modes), slip_(scene, modes->friction()), scale_(run::state_scale(scene)) {}

  /// Begins a turn at `section` with the disturbances that span the tube, one per column; the last `slow`
  /// columns are the slow part. False where the motion has no closed form, or an annular stop is armed.
  bool start(const std::vector<double>& section, const Eigen::MatrixXd& disturbances, std::size_t slow = 0) {
    base_ = {static_cast<std::size_t>(disturbances.cols()) - slow, slow};
    const State physical = scale_.state_in_seconds<State>(section);
    motion_.carry_no_tangents();
    motion_.set_phases(0);
    if (!motion_.enter(0, physical)) return false;
    const std::size_t modes =
        modes::joint_mode_of(motion_.machine().system().contacts, physical, motion_.rate_of(physical));
    if (modes != 0 && !motion_.enter(slip_.with_ways(motion_.machine(), modes, physical), physical))
      return false;
    if (!motion_.mode().annular_guards.empty()) return false;
    motion_.carry_tangents(disturbances);
    return true;
  }

  ExactMotion<N>& motion() { return motion_; }
  const ExactMotion<N>& motion() const { return motion_; }
  const run::StateScale& scale() const { return scale_; }  ///< scale of sections
  const PartSizes& base() const { return base_; }          ///< disturbances without the deflections

  /// Projections of the disturbances onto guard `e` of the present mode; valid until the next call.
  const Seen& seen(std::size_t e) {
    see(e, seen_);
    return seen_;
  }
  /// Writes these projections into an existing object.
  void see(std::size_t e, Seen& seen) { see_by(motion_.mode().guards[e].terms, 1, seen); }

  /// Slip margin of a touching contact in m/s: a guard that rises through zero where friction leaves
  /// saturation. Includes the projections of the disturbances onto this guard, and its row on the state.
  struct SlipGuard {
    typename ExactMotion<N>::GuardValue value;
    Seen seen;
    typename modes::ExactTypes<N>::Row row;
  };
  /// Slip guards of all contacts whose friction is saturated only above some slip; valid until the next call.
  std::span<const SlipGuard> slip_guards() {
    std::size_t count = 0;
    for (std::size_t t = 0; t < motion_.mode().touches.size(); ++t) {
      if (slip_.always(motion_, t)) continue;
      if (slips_.size() == count) slips_.emplace_back();
      SlipGuard& slip = slips_[count++];
      const modes::TouchWatch<N>& touch = motion_.mode().touches[t];
      slip.value = slip_.guard(motion_, t, motion_.physical());
      slip.row = scale_.length_m * touch.sliding;
      see_by(touch.sliding_of_free, scale_.length_m, slip.seen);
    }
    return std::span(slips_).first(count);
  }

  Spread spread_of(const std::vector<double>& values) const { return exact::tube::spread_of(values, base_); }

  Spread spread_over(const Seen& seen, double duration_s) const {
    return exact::tube::spread_over(seen, base_, duration_s);
  }

  /// Distances of the clamped contacts from p = 0. Their guards do not include p, which is positive only
  /// because the mode was entered from outside. A turn that starts in the mode therefore needs these margins.
  std::vector<TurnTube::LimitMargin> clamped_margins() {
    const auto& contacts = motion_.machine().system().contacts;
    const State here = motion_.physical();
    std::vector<TurnTube::LimitMargin> margins;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (motion_.mode().modes[i] != contact::Mode::clamped) continue;
      std::vector<double> widths;
      for (const State& z : motion_.tangents()) {
        const State physical = motion_.mode().from_free(z);
        widths.push_back(contacts[i].first_row.dot(physical.head(contacts[i].first_row.size()).transpose()));
      }
      margins.push_back({modes::kinematics_of(contacts[i], here, 0).penetration, spread_of(widths)});
    }
    return margins;
  }

  const SlipWatch<N>& slip() const { return slip_; }

  /// Norm of the generator with time in units of 1 / fastest rate.
  static double norm_of(const modes::LinearMode<N>& mode) {
    const Eigen::Index n = mode.rest.size();
    typename modes::ExactTypes<N>::Flow generator = mode.generator / mode.fastest_rad_per_s;
    generator.topRightCorner(n, n) *= mode.fastest_rad_per_s;
    generator.bottomLeftCorner(n, n) /= mode.fastest_rad_per_s;
    return generator.cwiseAbs().rowwise().sum().maxCoeff();
  }

 private:
  /// Projections of the disturbances onto a linear function of the free vibration, times `unit`.
  void see_by(const modes::ModalTerms& terms, double unit, Seen& seen) {
    motion_.put_tangent_sums(terms, unit, seen);
  }

  ExactMotion<N> motion_;
  SlipWatch<N> slip_;
  run::StateScale scale_;
  PartSizes base_;
  std::vector<SlipGuard> slips_;
  Seen seen_;
};

}  // namespace rubsweep::integrate::exact::tube
