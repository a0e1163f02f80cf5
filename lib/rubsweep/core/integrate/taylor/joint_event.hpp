#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/law/settle_slips.hpp"
#include "rubsweep/core/integrate/taylor/expansion.hpp"
#include "rubsweep/core/integrate/taylor/guard_search.hpp"

namespace rubsweep::integrate::taylor {

/// Event that ends a piece: the first change of mode or slip among all contacts, or the first friction that
/// leaves saturation.
struct JointEvent {
  double share = 1;                    ///< share of the searched duration
  std::optional<std::size_t> contact;  ///< empty: friction leaves saturation, and nothing changes
  contact::Mode next = contact::Mode::open;
  std::optional<contact::Slip> slip{};  ///< set: the slip of the contact changes, not its mode
};

/// First event within `duration_rad` of an expansion; share 1 without a contact if there is none.
/// `zero_terms` per contact, as in `SlipStart`.
template <int N>
JointEvent first_event(Expansion<N>& motion, const law::Dynamics<N, false>& dynamics,
                       const std::vector<int>& zero_terms, double duration_rad) {
  JointEvent first;
  for (std::size_t i = 0; i < zero_terms.size(); ++i) {
    const auto crossing =
        first_guard(motion.contact(i), motion.order(), motion.accuracy(), first.share * duration_rad);
    if (crossing) first = {first.share * crossing->share, i, crossing->next};
    if (dynamics.modes()[i] == contact::Mode::open) continue;
    if (dynamics.touches_dry(i)) {
      const SlipStart start{zero_terms[i], dynamics.poised(i) ? law::poised_slip : 0};
      const auto event = first_slip_event(motion.contact(i), motion.order(), motion.accuracy(),
                                          first.share * duration_rad, start);
      if (event) first = {first.share * event->share, i, contact::Mode::open, event->next};
    }
    const double share = saturated_share(motion.contact(i), motion.order(), first.share * duration_rad);
    if (share < 1) first = {first.share * share, std::nullopt, contact::Mode::open};
  }
  return first;
}

}  // namespace rubsweep::integrate::taylor
