#include "rubsweep/analysis/branch/orbits/contact_sequence.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace rubsweep::branch::orbits {
namespace {

using integrate::run::ModeSwitch;

/// Mode changes along a word such as "ocsro" (open, clamped, sprung, released), 0.1 rad apart, beginning at
/// `phase_rad`.
std::vector<ModeSwitch> changes(std::string_view word, double phase_rad = 0, int contact = 0) {
  const auto mode = [](char letter) {
    return letter == 'o'   ? contact::Mode::open
           : letter == 'c' ? contact::Mode::clamped
           : letter == 's' ? contact::Mode::sprung
                           : contact::Mode::released;
  };
  std::vector<ModeSwitch> list;
  for (std::size_t i = 0; i + 1 < word.size(); ++i)
    list.push_back({phase_rad + 0.1 * static_cast<double>(i), contact, mode(word[i]), mode(word[i + 1])});
  return list;
}

std::vector<ModeSwitch> operator+(std::vector<ModeSwitch> a, const std::vector<ModeSwitch>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(ContactSequenceSame, WhereverTheOrbitBegins) {
  EXPECT_TRUE(same_sequence(changes("ocsro"), changes("srocs")));
  EXPECT_FALSE(same_sequence(changes("ocsro"), changes("ocso")));
  EXPECT_TRUE(same_sequence({}, {}));
  EXPECT_FALSE(same_sequence(changes("ocsro"), {}));
}

/// Only the order of changes at the same contact counts: two stops may touch in either order.
TEST(ContactSequenceSame, ContactByContact) {
  EXPECT_TRUE(same_sequence(changes("oso", 0, 0) + changes("oso", 1, 1),
                            changes("oso", 0, 1) + changes("oso", 1, 0)));
  EXPECT_FALSE(same_sequence(changes("oso", 0, 0), changes("oso", 0, 1)));
}

TEST(ContactSequenceChange, AHit) {
  const auto change = sequence_change(changes("ocsro") + changes("ocso", 3), changes("ocsro"), 6.28);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->kind, SequenceChange::Kind::hit);
  EXPECT_NEAR(change->duration_rad, 0.2, 1e-12);
  EXPECT_EQ(describe(*change), "hit at stop 0");
}

TEST(ContactSequenceChange, TheOnlyHitOverTheEndOfThePeriod) {
  const auto change = sequence_change(changes("so", 0.1) + changes("os", 6.2), {}, 6.28);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->kind, SequenceChange::Kind::hit);
  EXPECT_NEAR(change->duration_rad, 0.18, 1e-12);
}

TEST(ContactSequenceChange, AnInterruption) {
  const auto change = sequence_change(changes("ocscso"), changes("ocso"), 6.28);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->kind, SequenceChange::Kind::interruption);
  EXPECT_NEAR(change->duration_rad, 0.1, 1e-12);
}

TEST(ContactSequenceChange, AFlightThatPartsAHit) {
  const auto apart = changes("ocsrocsro"), together = changes("ocsrscsro");
  EXPECT_TRUE(is_richer(apart, together));
  const auto change = sequence_change(apart, together, 6.28);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->kind, SequenceChange::Kind::parting);
  EXPECT_NEAR(change->duration_rad, 0.1, 1e-12);
  EXPECT_EQ(describe(*change), "flight within a hit at stop 0");
}

TEST(ContactSequenceChange, NoneThatIsKnown) {
  EXPECT_FALSE(sequence_change(changes("ocsro"), changes("oscro"), 6.28));
  EXPECT_FALSE(sequence_change(changes("oso", 0, 0) + changes("oso", 1, 1), {}, 6.28));
}

TEST(ContactSequenceSame, ContactAllAlongIsNotFlightAllAlong) {
  OrbitFacts flight, contact;
  contact.unbroken = {0};
  EXPECT_TRUE(same_sequence(flight.switches, contact.switches)) << "neither changes its mode";
  EXPECT_FALSE(same_contact(flight, contact));
  EXPECT_TRUE(same_contact(contact, contact));
}

}  // namespace
}  // namespace rubsweep::branch::orbits
