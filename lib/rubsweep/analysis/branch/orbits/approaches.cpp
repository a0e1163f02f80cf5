#include "rubsweep/analysis/branch/orbits/approaches.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/numerics/cubic_maximum.hpp"

namespace rubsweep::branch::orbits {
namespace {

using contact::Mode;
using integrate::run::ModeSwitch;
using State = std::vector<double>;

/// Guards of one contact at one sample.
struct Sampled {
  Mode mode = Mode::open;
  contact::Guards guards;
};

class ApproachSearch {
 public:
  ApproachSearch(const scene::Scene& scene, const SampledOrbit& orbit, std::span<const ModeSwitch> switches)
      : system_(integrate::run::scale<Eigen::Dynamic>(scene)),
        dynamics_(system_, 0),
        samples_(orbit.states),
        step_rad_(orbit.step_rad),
        closes_(orbit.closes),
        switches_(switches),
        guards_(system_.contacts.size()),
        before_(system_.contacts.size()) {}

  std::vector<Approach> all() {
    enter_first_modes();
    const auto count = static_cast<std::size_t>(samples_.cols());
    const std::size_t looks = closes_ ? count + 1 : count;
    for (std::size_t k = 0; k < looks; ++k) {
      take_modes_until(static_cast<double>(k) * step_rad_);
      look_at(static_cast<Eigen::Index>(k % count), static_cast<double>(k) * step_rad_);
      for (std::size_t i = 0; k > 0 && i < guards_.size(); ++i) add_between(i, k);
      before_ = guards_;
      changed_.assign(guards_.size(), false);
    }
    return std::move(approaches_);
  }

 private:
  /// First modes: of contacts that change theirs those before the first change, of the others by the state.
  void enter_first_modes() {
    changed_.assign(guards_.size(), false);
    auto& modes = dynamics_.modes();
    const State state = state_at(0);
    State rate(state.size());
    dynamics_(state, rate, 0);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const auto first = std::ranges::find(switches_, static_cast<int>(i), &ModeSwitch::contact);
      if (first != switches_.end()) {
        modes[i] = first->from;
      } else {
        dynamics_.enter_by_state(i, state, rate);
      }
    }
  }

  State state_at(Eigen::Index k) const {
    return {samples_.col(k).data(), samples_.col(k).data() + samples_.rows()};
  }

  void take_modes_until(double phase_rad) {
    for (; next_ < switches_.size() && switches_[next_].phase_rad <= phase_rad; ++next_) {
      const auto i = static_cast<std::size_t>(switches_[next_].contact);
      dynamics_.modes()[i] = switches_[next_].to;
      changed_[i] = true;
    }
  }

  void look_at(Eigen::Index k, double phase_rad) {
    const State state = state_at(k);
    State rate(state.size());
    dynamics_(state, rate, std::fmod(phase_rad, 2 * std::numbers::pi));
    for (std::size_t i = 0; i < guards_.size(); ++i) {
      guards_[i] = {dynamics_.modes()[i], dynamics_.guards(i, dynamics_.kinematics(i, state, rate))};
    }
  }

  /// Between the samples k - 1 and k.
  void add_between(std::size_t i, std::size_t k) {
    const Sampled &before = before_[i], &here = guards_[i];
    if (changed_[i] || before.mode != here.mode) return;
    for (std::size_t g = 0; g < static_cast<std::size_t>(here.guards.count); ++g) {
      const contact::Guard &begin = before.guards.list[g], &end = here.guards.list[g];
      if (!(begin.rate > 0 && end.rate <= 0 && begin.value < 0 && end.value < 0)) continue;
      const double highest =
          numerics::cubic_maximum(begin.value, begin.rate * step_rad_, end.value, end.rate * step_rad_);
      const double share = begin.rate / (begin.rate - end.rate);
      approaches_.push_back({static_cast<int>(i), here.mode, end.next,
                             (static_cast<double>(k - 1) + share) * step_rad_, std::max(-highest, 0.0)});
    }
  }

  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  integrate::law::Dynamics<Eigen::Dynamic, false> dynamics_;
  const Eigen::MatrixXd& samples_;
  double step_rad_;
  bool closes_;
  std::span<const ModeSwitch> switches_;
  std::size_t next_ = 0;  ///< index of the next switch
  std::vector<Sampled> guards_, before_;
  std::vector<bool> changed_;  ///< whose mode has changed since the sample before
  std::vector<Approach> approaches_;
};

}  // namespace

std::vector<Approach> approaches_of(const scene::Scene& scene, const SampledOrbit& orbit,
                                    std::span<const ModeSwitch> switches) {
  if (scene.twist || scene.contacts.empty() || orbit.states.cols() < 2) return {};
  return ApproachSearch(scene, orbit, switches).all();
}

}  // namespace rubsweep::branch::orbits
