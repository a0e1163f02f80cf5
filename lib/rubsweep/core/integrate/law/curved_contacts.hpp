#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "rubsweep/core/contact/curved_law.hpp"
#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::law {

/// Contacts of a system with a non-linear law, and the damping c of each contact since it began to touch, in
/// the scaled force S(p) (1 + c p'). Linear contacts have an entry, too, but no damping.
template <int N>
class CurvedContacts {
  using Contact = run::ScaledContact<N>;

 public:
  /// `system` must outlive this object.
  explicit CurvedContacts(const run::ScaledSystem<N>& system)
      : system_(system), damping_(system.contacts.size(), 0) {
    for (std::size_t i = 0; i < damping_.size(); ++i) begin_impact(i, 0);
  }

  double impact_damping(std::size_t i) const { return damping_[i]; }

  /// Begins an impact at contact `i` with this closing speed.
  void begin_impact(std::size_t i, double closing_speed) {
    const Contact& c = system_.contacts[i];
    if (!c.law) return;
    const auto& given_m_per_s = c.law->approach_m_per_s();
    const double approach = given_m_per_s
                                ? *given_m_per_s / c.slip_scale_m_per_s
                                : std::max(closing_speed, contact::CurvedLaw::slowest_approach * c.clearance);
    damping_[i] = c.law->factor() / approach;
  }

  /// Begins an impact for a run that starts here, perhaps inside the wall. The approach speed is that with
  /// which a free mass would have had to touch the wall to reach this state.
  void begin_inside(std::size_t i, const contact::Kinematics& k) {
    const Contact& c = system_.contacts[i];
    if (!c.law) return;
    const double energy = c.law->energy_j(std::max(0.0, k.penetration) * c.length_m) / c.length_m;
    begin_impact(i, std::sqrt(k.closing_speed * k.closing_speed + 2 * c.mobility() * energy));
  }

  /// A separate function, so that it does not take registers from the loop of linear contacts.
  [[gnu::noinline]] contact::NormalForce force(std::size_t i, contact::Mode mode, double p, double v) const {
    if (mode == contact::Mode::open) return {};
    const double spring = spring_n(i, p);
    return {spring, mode == contact::Mode::released ? 0 : spring * (1 + damping_[i] * v)};
  }

  contact::ForceSlopes slopes(std::size_t i, contact::Mode mode, double p, double v) const {
    if (mode == contact::Mode::open) return {};
    const Contact& c = system_.contacts[i];
    const double slope = c.length_m * c.law->slope_n_per_m(p * c.length_m);
    if (mode == contact::Mode::released) return {slope, 0, 0};
    return {slope, slope * (1 + damping_[i] * v), spring_n(i, p) * damping_[i]};
  }

 private:
  double spring_n(std::size_t i, double p) const {
    const Contact& c = system_.contacts[i];
    return c.law->force_n(p * c.length_m);
  }

  const run::ScaledSystem<N>& system_;
  std::vector<double> damping_;
};

}  // namespace rubsweep::integrate::law
