#include "rubsweep/ring/changes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ring/multiprecision.hpp"
#include "ring/random_system.hpp"
#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::ring {
namespace {

std::vector<double> grid(double top_rpm, int count) {
  return batch::evenly_spaced(0.0, top_rpm * rpm, count);
}

TEST(ChangesFind, WithoutFrictionAndSpeedOneLoadOnlyDivergesAndCouples) {
  System system = spring_masses({60}, 0);
  system.loads[0].motion = Motion::radial;
  const auto changes = find_changes(normal_form(system), grid(1500, 301));
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].after, (Signature{1, 1, 0}));
  EXPECT_NEAR(changes[0].speed_rad_per_s, 17.2, 1e-12);
  EXPECT_EQ(changes[1].after, (Signature{0, 0, 0}));
  EXPECT_EQ(changes[2].after, (Signature{0, 0, 1}));
  EXPECT_NEAR(changes[2].root.real(), 0, 1e-10);
}

TEST(ChangesFind, PolishAndBisectionAgree) {
  for (const double friction : {0.0, 0.1}) {
    const NormalForm form = normal_form(spring_masses({60, 87}, friction));
    const auto polished = find_changes(form, grid(1500, 301));
    const auto bisected = find_changes(form, grid(1500, 301), {.polish = false});
    // Bisection alone may separate the two halves of one merger by rounding.
    const auto is_among = [](const Change& change, const std::vector<Change>& others) {
      return std::any_of(others.begin(), others.end(), [&](const Change& other) {
        return std::abs(change.speed_rad_per_s - other.speed_rad_per_s) < 1e-8 * (1 + other.speed_rad_per_s);
      });
    };
    int with_polish = 0, without = 0;
    for (const Change& change : polished) {
      EXPECT_TRUE(is_among(change, bisected)) << change.speed_rad_per_s / rpm;
      with_polish += change.evaluations;
    }
    for (const Change& change : bisected) {
      EXPECT_TRUE(is_among(change, polished)) << change.speed_rad_per_s / rpm;
      without += change.evaluations;
    }
    EXPECT_LT(with_polish, without);
  }
}

TEST(ChangesFind, DoesNotDependOnTheSpeedsBetween) {
  const NormalForm form = normal_form(spring_masses({60, 87}));
  const auto coarse = find_changes(form, grid(1500, 301)), fine = find_changes(form, grid(1500, 1733));
  ASSERT_EQ(coarse.size(), fine.size());
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_NEAR(coarse[i].speed_rad_per_s, fine[i].speed_rad_per_s, 1e-11 * (1 + fine[i].speed_rad_per_s));
  }
}

TEST(ChangesFind, TheNumberOfUnstableRootsChangesThereWith50Digits) {
  int seen = 0;
  for (const std::vector<double>& angles : {std::vector<double>{60}, {60, 87}, {60, 110}}) {
    const System system = spring_masses(angles);
    for (const Change& change : find_changes(normal_form(system), grid(1500, 301))) {
      const double speed = change.speed_rad_per_s;
      if (speed == 0 || change.before.unstable_eigenvalues() == change.after.unstable_eigenvalues()) continue;
      EXPECT_EQ(routh_hurwitz_with_50_digits(system, speed * (1 - 1e-9)),
                change.before.unstable_eigenvalues())
          << speed / rpm;
      EXPECT_EQ(routh_hurwitz_with_50_digits(system, speed * (1 + 1e-9)), change.after.unstable_eigenvalues())
          << speed / rpm;
      ++seen;
    }
  }
  EXPECT_GT(seen, 15);
}

TEST(ChangesFind, RootsMergeThereWith50Digits) {
  int seen = 0;
  for (const double friction : {0.0, 0.1}) {
    const System system = spring_masses({60, 87}, friction);
    for (const Change& change : find_changes(normal_form(system), grid(1500, 301))) {
      const bool merges = change.before.unstable_eigenvalues() == change.after.unstable_eigenvalues() ||
                          (friction == 0 && change.root.imag() > 0);
      if (!merges) continue;
      const double below =
          discriminant_with_50_digits(system, change.speed_rad_per_s * (1 - 1e-11), change.root);
      const double above =
          discriminant_with_50_digits(system, change.speed_rad_per_s * (1 + 1e-11), change.root);
      EXPECT_LT(below * above, 0) << change.speed_rad_per_s / rpm;
      ++seen;
    }
  }
  EXPECT_GT(seen, 6);
}

TEST(ChangesFind, FrictionStartsWithTheRotation) {
  System system = spring_masses({60});
  system.loads[0].motion = Motion::radial;
  const auto changes = find_changes(normal_form(system), grid(100, 11));
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].speed_rad_per_s, 0);
  EXPECT_EQ(changes[0].after, (Signature{0, 0, 1}));
}

TEST(ChangesFind, ANeutralPairOnAGridPointAtZeroIsNoOnset) {
  System system = spring_masses({60}, 0.1);
  system.loads[0].motion = Motion::tangential;
  // The forward wave of the free ring stands still at exactly 17.2 rad/s.
  const std::vector<double> speeds{10, critical_speed(system.ring), 30};
  EXPECT_TRUE(find_changes(normal_form(system), speeds).empty());
}

TEST(ChangesFind, ASpeedExactlyOnAnOnsetDoesNotSpoilIt) {
  System system = spring_masses({60});
  system.loads[0].motion = Motion::radial;
  const double onset = (std::sqrt(5 * 1e4 - 4 * 17.2 * 17.2) - 4 * 17.2) / 5;  // Omega_cs1
  const auto changes = find_changes(normal_form(system), std::vector<double>{onset - 1, onset, onset + 1});
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NEAR(changes[0].speed_rad_per_s, onset, 1e-12);
}

TEST(ChangesFind, EqualLoadsDivergeTogether) {
  System system = spring_masses({10, 20, 30});
  for (Load& load : system.loads) load.motion = Motion::tangential;
  const auto changes = find_changes(normal_form(system), std::vector<double>{99.8, 105});
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NEAR(changes[0].speed_rad_per_s, 100, 1e-8);
  EXPECT_EQ(changes[0].after.growing_real - changes[0].before.growing_real, 3);
}

TEST(ChangesFind, OfRandomSystemsNeverFails) {
  RandomSystems random(11, 4);
  for (int i = 0; i < 60; ++i) {
    const System system = random.next();
    const NormalForm form = normal_form(system);
    const auto speeds = batch::evenly_spaced(0.0, 3 * critical_speed(system.ring), 60);
    Signature now = signature(form, 0.0);
    for (const Change& change : find_changes(form, speeds)) {
      EXPECT_EQ(change.before, now);
      now = change.after;
    }
    EXPECT_EQ(now, signature(form, speeds.back()));
  }
}

}  // namespace
}  // namespace rubsweep::ring
