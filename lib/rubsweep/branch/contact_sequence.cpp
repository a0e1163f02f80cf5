#include "rubsweep/branch/contact_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace rubsweep::branch {
namespace {

using integrate::run::ModeSwitch;

std::vector<ModeSwitch> at_contact(Switches all, int contact) {
  std::vector<ModeSwitch> some;
  std::ranges::copy_if(all, std::back_inserter(some),
                       [&](const ModeSwitch& change) { return change.contact == contact; });
  return some;
}

int contacts_of(Switches a, Switches b) {
  int contacts = 0;
  for (const Switches switches : {a, b})
    for (const ModeSwitch& change : switches) contacts = std::max(contacts, change.contact + 1);
  return contacts;
}

bool same_change(const ModeSwitch& a, const ModeSwitch& b) { return a.from == b.from && a.to == b.to; }

/// Equal, or one a rotation of the other.
bool cyclically_equal(const std::vector<ModeSwitch>& a, const std::vector<ModeSwitch>& b) {
  if (a.size() != b.size()) return false;
  if (a.empty()) return true;
  std::vector<ModeSwitch> twice = b;
  twice.insert(twice.end(), b.begin(), b.end());
  return !std::ranges::search(twice, a, same_change).empty();
}

/// `count` changes of a closed sequence from number `first` on, and what is left without them.
struct Parted {
  double duration_rad = 0;
  std::vector<ModeSwitch> left;
};

Parted part(const std::vector<ModeSwitch>& all, std::size_t first, std::size_t count, double period_rad) {
  Parted parted;
  const std::size_t last = first + count - 1;
  parted.duration_rad = all[last % all.size()].phase_rad - all[first].phase_rad;
  if (last >= all.size()) parted.duration_rad += period_rad;
  for (std::size_t i = last + 1; i < first + all.size(); ++i) parted.left.push_back(all[i % all.size()]);
  return parted;
}

}  // namespace

bool same_sequence(Switches a, Switches b) {
  for (int contact = 0; contact < contacts_of(a, b); ++contact) {
    if (!cyclically_equal(at_contact(a, contact), at_contact(b, contact))) return false;
  }
  return true;
}

std::optional<ExtraBlock> extra_block(Switches richer, Switches poorer, double period_rad) {
  std::optional<ExtraBlock> shortest;
  for (int contact = 0; contact < contacts_of(richer, poorer); ++contact) {
    const auto rich = at_contact(richer, contact), poor = at_contact(poorer, contact);
    if (cyclically_equal(rich, poor)) continue;
    if (shortest || rich.size() <= poor.size()) return std::nullopt;
    const std::size_t count = rich.size() - poor.size();
    for (std::size_t first = 0; first < rich.size(); ++first) {
      if (rich[first].from != rich[(first + count - 1) % rich.size()].to) continue;
      const Parted parted = part(rich, first, count, period_rad);
      if (!cyclically_equal(parted.left, poor)) continue;
      if (!shortest || parted.duration_rad < shortest->duration_rad)
        shortest = ExtraBlock{contact, rich[first].from, parted.duration_rad};
    }
    if (!shortest) return std::nullopt;
  }
  return shortest;
}

std::string describe(const ExtraBlock& block) {
  if (block.from == contact::Mode::open) return fmt::format("hit at stop {}", block.contact);
  return fmt::format("{} interrupted at stop {}", contact::to_string(block.from), block.contact);
}

}  // namespace rubsweep::branch
