#include "rubsweep/analysis/branch/orbits/even_contacts.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "rubsweep/core/integrate/law/contact_states.hpp"

namespace rubsweep::branch::orbits {
namespace {

using integrate::run::ModeSwitch;
using System = integrate::run::ScaledSystem<Eigen::Dynamic>;
using Map = Eigen::Map<const Eigen::VectorXd>;

/// A penetration that varies by less is even. The orbits that part a whole circle from one in partial contact
/// are then too near to each other to be told apart by what rounding leaves of their modes.
constexpr double most_spread = 1e-8;

double penetration(const System& system, std::size_t contact, const double* state) {
  const Eigen::Index n = system.coordinates();
  return integrate::law::contact_frame(system.contacts[contact], Map(state, n), Map(state + n, n))
      .penetration;
}

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

}  // namespace rubsweep::branch::orbits
