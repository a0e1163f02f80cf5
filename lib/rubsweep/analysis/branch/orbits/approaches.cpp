#include "rubsweep/analysis/branch/orbits/approaches.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "rubsweep/core/integrate/law/contact_states.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/numerics/cubic_maximum.hpp"

namespace rubsweep::branch::orbits {
namespace {

using integrate::run::ModeSwitch;
using System = integrate::run::ScaledSystem<Eigen::Dynamic>;
using Map = Eigen::Map<const Eigen::VectorXd>;

/// Largest variation of a penetration that counts as even. With such a small variation, rounding decides
/// whether contact is full or partial.
constexpr double most_spread = 1e-8;

double penetration(const System& system, std::size_t contact, const double* state) {
  const Eigen::Index n = system.coordinates();
  return integrate::law::contact_frame(system.contacts[contact], Map(state, n), Map(state + n, n))
      .penetration;
}

using contact::Mode;
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
  /// Sets the modes at the start. A contact that changes its mode starts in the mode before its first change;
  /// any other contact starts in the mode of its first state.
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

  /// Adds an approach of contact i between the samples k - 1 and k, if there is one.
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
  std::vector<bool> changed_;  ///< contacts whose mode changed since the last sample
  std::vector<Approach> approaches_;
};

}  // namespace

EvenContacts::EvenContacts(const scene::Scene& scene)
    : system_(integrate::run::scale<Eigen::Dynamic>(scene)),
      ranges_(system_.contacts.size(),
              {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {}

void EvenContacts::add(const Eigen::Ref<const Eigen::MatrixXd>& states) {
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    auto& [least, largest] = ranges_[i];
    for (Eigen::Index k = 0; k < states.cols() && !(largest - least > most_spread); ++k) {
      const double here = penetration(system_, i, states.col(k).data());
      least = std::min(least, here);
      largest = std::max(largest, here);
    }
  }
}

std::vector<EvenContact> EvenContacts::list() const {
  std::vector<EvenContact> even;
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    const auto [least, largest] = ranges_[i];
    if (!(largest >= least && largest - least <= most_spread)) continue;
    const auto touching = contact::guard_forms(contact::Mode::open, system_.contacts[i].damping > 0);
    even.push_back({static_cast<int>(i), (least + largest) / 2, largest - least, touching.list.front().next});
  }
  return even;
}

double penetration_at(const scene::Scene& scene, const Eigen::VectorXd& state, int contact) {
  return penetration(integrate::run::scale<Eigen::Dynamic>(scene), static_cast<std::size_t>(contact),
                     state.data());
}

void EvenContacts::settle(OrbitFacts& facts) const {
  facts.even = list();
  for (const EvenContact& even : facts.even) {
    std::erase_if(facts.switches, [&](const ModeSwitch& at) {
      if (at.contact != even.contact) return false;
      if (at.from == contact::Mode::open) --facts.hits;
      return true;
    });
  }
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    const int contact = static_cast<int>(i);
    if (ranges_[i].least + ranges_[i].largest > 0 &&
        std::ranges::find(facts.switches, contact, &ModeSwitch::contact) == facts.switches.end())
      facts.unbroken.push_back(contact);
  }
  if (facts.even.empty() || facts.even.size() < ranges_.size()) return;
  facts.touched = !facts.unbroken.empty();
  facts.contact_fraction = facts.touched ? 1 : 0;
}

std::vector<Approach> approaches_of(const scene::Scene& scene, const SampledOrbit& orbit,
                                    std::span<const ModeSwitch> switches) {
  if (scene.twist || scene.contacts.empty() || orbit.states.cols() < 2) return {};
  return ApproachSearch(scene, orbit, switches).all();
}

}  // namespace rubsweep::branch::orbits
