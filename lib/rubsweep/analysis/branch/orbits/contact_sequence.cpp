#include "rubsweep/analysis/branch/orbits/contact_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace rubsweep::branch::orbits {
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

/// Whether two sequences are equal up to a rotation.
bool cyclically_equal(const std::vector<ModeSwitch>& a, const std::vector<ModeSwitch>& b) {
  if (a.size() != b.size()) return false;
  if (a.empty()) return true;
  std::vector<ModeSwitch> twice = b;
  twice.insert(twice.end(), b.begin(), b.end());
  return std::search(twice.begin(), twice.end(), a.begin(), a.end(), same_change) != twice.end();
}

long hits_of(Switches switches) {
  return std::ranges::count(switches, contact::Mode::open, &ModeSwitch::from);
}

/// Part of the closed sequence `all`: `count` mode changes from index `first` on. After the last change of
/// `all` the first one follows, one period later.
std::vector<ModeSwitch> stretch(const std::vector<ModeSwitch>& all, std::size_t first, std::size_t count,
                                double period_rad) {
  std::vector<ModeSwitch> part;
  for (std::size_t i = first; i < first + count; ++i) {
    part.push_back(all[i % all.size()]);
    if (i >= all.size()) part.back().phase_rad += period_rad;
  }
  return part;
}

/// Number of changes that agree from index `i` of one closed sequence and from index `j` of another.
std::size_t agreeing(const std::vector<ModeSwitch>& a, std::size_t i, const std::vector<ModeSwitch>& b,
                     std::size_t j) {
  std::size_t count = 0;
  while (count < std::min(a.size(), b.size()) &&
         same_change(a[(i + count) % a.size()], b[(j + count) % b.size()]))
    ++count;
  return count;
}

/// Kind of change, from the parts of both sequences that differ; empty for an unknown pattern.
std::optional<SequenceChange> change_of(const std::vector<ModeSwitch>& rich,
                                        const std::vector<ModeSwitch>& poor, int contact) {
  using Kind = SequenceChange::Kind;
  if (rich.empty()) return std::nullopt;
  const double begin_rad = rich.front().phase_rad, end_rad = rich.back().phase_rad;
  SequenceChange change{
      Kind::hit, contact, rich.front().from, rich.front().to, end_rad - begin_rad, (begin_rad + end_rad) / 2};
  const bool returns = rich.front().from == rich.back().to;
  if (poor.empty() && returns) {
    if (change.from != contact::Mode::open) change.kind = Kind::interruption;
    return change;
  }
  if (hits_of(rich) == 1 && hits_of(poor) == 0 && rich.front().to == contact::Mode::open &&
      rich.size() == 2) {
    change.kind = Kind::parting;
    return change;
  }
  return std::nullopt;
}

/// Kind of change at one contact whose sequences differ.
std::optional<SequenceChange> change_at(const std::vector<ModeSwitch>& rich,
                                        const std::vector<ModeSwitch>& poor, int contact, double period_rad) {
  if (rich.empty()) return std::nullopt;
  std::size_t most = 0;
  std::optional<SequenceChange> shortest;
  const auto offer = [&](const std::optional<SequenceChange>& change) {
    if (change && (!shortest || change->duration_rad < shortest->duration_rad)) shortest = change;
  };
  for (std::size_t i = 0; i < rich.size() && poor.empty(); ++i)
    offer(change_of(stretch(rich, i, rich.size(), period_rad), poor, contact));
  for (std::size_t i = 0; i < rich.size(); ++i) {
    for (std::size_t j = 0; j < poor.size(); ++j) {
      const std::size_t same = agreeing(rich, i, poor, j);
      if (same == 0 || same < most) continue;
      if (same > most) shortest.reset();
      most = same;
      offer(change_of(stretch(rich, i + same, rich.size() - same, period_rad),
                      stretch(poor, j + same, poor.size() - same, period_rad), contact));
    }
  }
  return shortest;
}

}  // namespace

bool same_sequence(Switches a, Switches b) {
  for (int contact = 0; contact < contacts_of(a, b); ++contact) {
    if (!cyclically_equal(at_contact(a, contact), at_contact(b, contact))) return false;
  }
  return true;
}

bool same_contact(const OrbitFacts& a, const OrbitFacts& b) {
  return a.unbroken == b.unbroken && same_sequence(a.switches, b.switches);
}

bool is_richer(Switches a, Switches b) {
  const long more = hits_of(a) - hits_of(b);
  return more != 0 ? more > 0 : a.size() > b.size();
}

std::optional<SequenceChange> sequence_change(Switches richer, Switches poorer, double period_rad) {
  std::optional<SequenceChange> change;
  for (int contact = 0; contact < contacts_of(richer, poorer); ++contact) {
    const auto rich = at_contact(richer, contact), poor = at_contact(poorer, contact);
    if (cyclically_equal(rich, poor)) continue;
    if (change) return std::nullopt;
    change = change_at(rich, poor, contact, period_rad);
    if (!change) return std::nullopt;
  }
  return change;
}

std::string describe(const SequenceChange& change) {
  switch (change.kind) {
    case SequenceChange::Kind::hit: return fmt::format("hit at stop {}", change.contact);
    case SequenceChange::Kind::interruption:
      return fmt::format("{} interrupted at stop {}", contact::to_string(change.from), change.contact);
    case SequenceChange::Kind::parting: return fmt::format("flight within a hit at stop {}", change.contact);
    case SequenceChange::Kind::even: return fmt::format("contact all along at stop {}", change.contact);
  }
  return "";
}

}  // namespace rubsweep::branch::orbits
