#include "rubsweep/core/contact/contact_mode.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/contact/random_contact.hpp"

namespace rubsweep::contact {
namespace {

constexpr std::array all_modes{Mode::open, Mode::clamped, Mode::sprung, Mode::released};

std::vector<Guard> listed(const Guards& guards) {
  return {guards.list.begin(), guards.list.begin() + guards.count};
}

/// Random states: anywhere, exactly at first touch, and exactly or nearly on the clamp lines d v = +-K p.
Kinematics random_state(RandomContact& random, double stiffness, double damping, int kind) {
  Kinematics k{random.penetration(), random.speed(), random.either_sign(random.log_uniform(1e-3, 1e4))};
  if (kind % 5 == 1) k.penetration = 0;
  if (kind % 5 >= 2 && damping > 0) {
    const double off = kind % 5 == 4 ? random.either_sign(random.log_uniform(1e-12, 0.5)) : 0;
    k.closing_speed =
        std::copysign(stiffness * std::abs(k.penetration) / damping * (1 + off), k.closing_speed);
  }
  return k;
}

double random_damping(RandomContact& random, int trial) { return trial % 7 == 0 ? 0 : random.damping(); }

TEST(ContactModeOf, NamesThePieceThatTheForceLawIsOn) {
  RandomContact random(1);
  std::array<int, mode_count> seen{};
  for (int trial = 0; trial < 40'000; ++trial) {
    const double stiffness = random.stiffness(), damping = random_damping(random, trial);
    const auto [p, v, a] = random_state(random, stiffness, damping, trial);
    const Mode mode = mode_of(stiffness, damping, p, v);
    const NormalForce force = force_in_mode(mode, stiffness, damping, p, v);
    EXPECT_EQ(force.spring_n, elastogap(stiffness, damping, p, v).spring_n);
    EXPECT_EQ(force.total_n, elastogap(stiffness, damping, p, v).total_n);
    ++seen[static_cast<std::size_t>(mode)];
  }
  for (const int count : seen) EXPECT_GT(count, 1000);
}

TEST(ContactModeOf, AtTheBoundaries) {
  EXPECT_EQ(mode_of(1, 1, 0, 5), Mode::open);
  EXPECT_EQ(mode_of(1, 1, -0.0, -5), Mode::open);
  EXPECT_EQ(mode_of(2, 1, 1, 2), Mode::clamped);
  EXPECT_EQ(mode_of(2, 1, 1, -2), Mode::released);
  EXPECT_EQ(mode_of(2, 1, 1, std::nextafter(2.0, 0.0)), Mode::sprung);
  EXPECT_EQ(mode_of(2, 1, 1, std::nextafter(-2.0, 0.0)), Mode::sprung);
}

TEST(ContactModeOf, WithoutDampingEveryTouchIsSprung) {
  for (const double v : {-1e9, -1.0, 0.0, 1.0, 1e9}) EXPECT_EQ(mode_of(1, 0, 1e-9, v), Mode::sprung);
}

TEST(ContactModeForceIn, ContinuesThePieceBeyondItsEnd) {
  EXPECT_EQ(force_in_mode(Mode::open, 2, 3, 1, 1).total_n, 0);
  EXPECT_EQ(force_in_mode(Mode::clamped, 2, 3, -1, 7).total_n, -4);
  EXPECT_EQ(force_in_mode(Mode::sprung, 2, 3, 1, -5).total_n, -13);
  EXPECT_EQ(force_in_mode(Mode::released, 2, 3, 1, 9).total_n, 0);
  EXPECT_EQ(force_in_mode(Mode::released, 2, 3, 1, 9).spring_n, 2);
}

TEST(ContactModeGuardsOf, AreBelowZeroInsideTheMode) {
  RandomContact random(2);
  for (int trial = 0; trial < 40'000; ++trial) {
    const double stiffness = random.stiffness(), damping = random_damping(random, trial);
    Kinematics k = random_state(random, stiffness, damping, trial % 2 == 0 ? 0 : 4);  // no exact ties
    const Mode mode = mode_of(stiffness, damping, k.penetration, k.closing_speed);
    for (const Guard& guard : listed(guards_of(mode, stiffness, damping, k))) EXPECT_LT(guard.value, 0);
  }
}

TEST(ContactModeGuardsOf, RateIsTheDifferenceQuotientAlongAMotion) {
  RandomContact random(3);
  for (int trial = 0; trial < 4000; ++trial) {
    const double stiffness = random.uniform(0.1, 10), damping = trial % 7 == 0 ? 0 : random.uniform(0.1, 10);
    const double p = random.uniform(-1, 1), v = random.uniform(-1, 1), a = random.uniform(-1, 1);
    const auto along = [=](double t) { return Kinematics{p + v * t + a * t * t / 2, v + a * t, a}; };
    for (const Mode mode : all_modes) {
      // The guards are quadratic in t, so a central difference is exact up to rounding.
      const double h = 1e-3;
      const auto before = listed(guards_of(mode, stiffness, damping, along(-h)));
      const auto now = listed(guards_of(mode, stiffness, damping, along(0)));
      const auto after = listed(guards_of(mode, stiffness, damping, along(h)));
      for (std::size_t i = 0; i < now.size(); ++i) {
        EXPECT_NEAR(now[i].rate, (after[i].value - before[i].value) / (2 * h), 1e-11);
      }
    }
  }
}

TEST(ContactModeGuardsOf, OnlyThoseOfTheMode) {
  const Kinematics k{1, 1, 1};
  const auto next_modes = [&](Mode mode, double damping) {
    std::vector<Mode> next;
    for (const Guard& guard : listed(guards_of(mode, 1, damping, k))) next.push_back(guard.next);
    return next;
  };
  EXPECT_EQ(next_modes(Mode::open, 1), (std::vector{Mode::clamped}));
  EXPECT_EQ(next_modes(Mode::clamped, 1), (std::vector{Mode::sprung}));
  EXPECT_EQ(next_modes(Mode::sprung, 1), (std::vector{Mode::clamped, Mode::released}));
  EXPECT_EQ(next_modes(Mode::released, 1), (std::vector{Mode::open, Mode::sprung}));
  EXPECT_EQ(next_modes(Mode::open, 0), (std::vector{Mode::sprung}));
  EXPECT_EQ(next_modes(Mode::sprung, 0), (std::vector{Mode::open}));
}

TEST(ContactModeAfter, FollowsAnySmoothMotionThroughTheModes) {
  // Where a finely sampled motion changes its mode, the guards of the old mode must lead to the same new
  // mode.
  RandomContact random(4);
  int changes = 0;
  for (int motion = 0; motion < 60; ++motion) {
    const double stiffness = random.uniform(0.2, 5), damping = motion % 6 == 0 ? 0 : random.uniform(0.2, 5);
    const double mean = random.uniform(-0.8, 0.8), w = random.uniform(1, 4), second = random.uniform(0, 0.5);
    const auto at = [=](double t) {
      return Kinematics{mean + std::sin(t) + second * std::sin(w * t),
                        std::cos(t) + second * w * std::cos(w * t),
                        -std::sin(t) - second * w * w * std::sin(w * t)};
    };
    Mode mode = mode_of(stiffness, damping, at(0).penetration, at(0).closing_speed);
    for (int i = 1; i < 20'000; ++i) {
      const Kinematics k = at(i * 1e-3);
      const Mode now = mode_of(stiffness, damping, k.penetration, k.closing_speed);
      EXPECT_EQ(mode_after(mode, stiffness, damping, k), now) << to_string(mode) << " at t = " << i * 1e-3;
      changes += now != mode;
      mode = now;
    }
  }
  EXPECT_GT(changes, 500);
}

TEST(ContactModeAfter, TouchStartsClampedWithDampingAndSprungWithout) {
  EXPECT_EQ(mode_after(Mode::open, 1, 1, {0, 1, 0}), Mode::clamped);
  EXPECT_EQ(mode_after(Mode::open, 1, 0, {0, 1, 0}), Mode::sprung);
}

TEST(ContactModeAfter, PastZeroButFallingIsAReturnFromAGrazeAndNoEvent) {
  EXPECT_EQ(mode_after(Mode::open, 1, 1, {1e-9, -1, 0}), Mode::open);
  EXPECT_EQ(mode_after(Mode::open, 1, 0, {1e-9, -1, 0}), Mode::open);
  EXPECT_EQ(mode_after(Mode::sprung, 1, 0, {-1e-9, 1, 0}), Mode::sprung);
  EXPECT_EQ(mode_after(Mode::clamped, 1, 1, {2, 1, 2}), Mode::clamped);       // K p - d v = 1, rate -1
  EXPECT_EQ(mode_after(Mode::sprung, 1, 1, {1, 2, 1}), Mode::sprung);         // d v - K p = 1, rate -1
  EXPECT_EQ(mode_after(Mode::sprung, 1, 1, {1, -2, 3}), Mode::sprung);        // -(K p + d v) = 1, rate -1
  EXPECT_EQ(mode_after(Mode::released, 1, 1, {1, 0.5, -1}), Mode::released);  // K p + d v = 1.5, rate -0.5
}

TEST(ContactModeAfter, AtExactZerosTheRateDecides) {
  EXPECT_EQ(mode_after(Mode::open, 1, 1, {0, 0, 1}), Mode::open);
  EXPECT_EQ(mode_after(Mode::open, 1, 1, {0, -1, 1}), Mode::open);
  EXPECT_EQ(mode_after(Mode::clamped, 1, 1, {1, 1, 0}), Mode::sprung);
  EXPECT_EQ(mode_after(Mode::clamped, 1, 1, {1, 1, 1}), Mode::clamped);
  EXPECT_EQ(mode_after(Mode::sprung, 1, 1, {1, 1, 2}), Mode::clamped);
  EXPECT_EQ(mode_after(Mode::sprung, 1, 1, {1, -1, 0}), Mode::released);
  EXPECT_EQ(mode_after(Mode::released, 1, 1, {1, -1, 2}), Mode::sprung);
  EXPECT_EQ(mode_after(Mode::released, 1, 1, {0, -1, 0}), Mode::open);
  EXPECT_EQ(mode_after(Mode::sprung, 1, 0, {0, -1, 0}), Mode::open);
}

TEST(ContactModeAfter, HopsThroughSeveralModesAtOnce) {
  // A contact that begins and ends within one step: K p - d v, -(K p + d v) and -p are all positive and
  // rising.
  const Kinematics gone{-0.1, -1, -2};
  EXPECT_EQ(mode_after(Mode::clamped, 1, 1, gone), Mode::open);
  EXPECT_EQ(mode_after(Mode::sprung, 1, 1, gone), Mode::open);
  EXPECT_EQ(mode_after(Mode::released, 1, 1, gone), Mode::open);
  EXPECT_EQ(mode_after(Mode::open, 1, 1, {2, 1, 0}), Mode::sprung);
}

TEST(ContactModeAfter, ComesToRestFromEveryStateAndMode) {
  RandomContact random(5);
  for (int trial = 0; trial < 40'000; ++trial) {
    const double stiffness = random.stiffness(), damping = random_damping(random, trial);
    const Kinematics k = random_state(random, stiffness, damping, trial);
    for (const Mode mode : all_modes) {
      const Mode after = mode_after(mode, stiffness, damping, k);
      EXPECT_EQ(mode_after(after, stiffness, damping, k), after);
    }
  }
}

TEST(ContactMode, Names) {
  EXPECT_EQ(to_string(Mode::open), "open");
  EXPECT_EQ(to_string(Mode::clamped), "clamped");
  EXPECT_EQ(to_string(Mode::sprung), "sprung");
  EXPECT_EQ(to_string(Mode::released), "released");
}

/// With a damping far below rounding, both guards of sprung are zero at p = 0: the closing speed decides
/// between them.
TEST(ContactModeThrough, OutOfSprungTheClosingSpeedDecides) {
  const Kinematics separating{-1e-16, -1, 0}, closing{1e-17, 1, 0};
  EXPECT_EQ(mode_through(Mode::sprung, Mode::clamped, separating), Mode::released);
  EXPECT_EQ(mode_through(Mode::sprung, Mode::released, separating), Mode::released);
  EXPECT_EQ(mode_through(Mode::sprung, Mode::released, closing), Mode::clamped);
  EXPECT_EQ(mode_through(Mode::sprung, Mode::open, separating), Mode::open);
  EXPECT_EQ(mode_through(Mode::open, Mode::clamped, closing), Mode::clamped);
  EXPECT_EQ(mode_through(Mode::released, Mode::open, separating), Mode::open);
}

TEST(ContactModeAfter, ARotorThatLeavesAnAllButUndampedWallIsFree) {
  for (const double penetration : {1e-17, 0.0, -1e-17, -1e-15})
    EXPECT_NE(mode_after(Mode::sprung, 2e6, 1e-12, {penetration, -0.3, 0}), Mode::clamped) << penetration;
  EXPECT_EQ(mode_after(Mode::sprung, 2e6, 1e-12, {-1e-15, -0.3, 0}), Mode::open);
}

}  // namespace
}  // namespace rubsweep::contact
