#include "rubsweep/core/response/motion/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::response::motion {
namespace {

TEST(Record, HoldsTwoWindowsOfEqualLength) {
  const auto scene = test::one_mass_scene(1, 1, 0, 1, 2e-3);
  ResponseOptions options;
  options.window_revolutions = 3;
  options.samples_per_revolution = 4;
  Record record(scene, options);
  const auto state = [](int k) { return std::vector<double>{1.0 * k, 10.0 * k, 100.0 * k, 1000.0 * k}; };
  record.begin(state(0));
  for (int k = 1; k <= 6; ++k) {
    integrate::run::TurnReport turn;
    turn.sample_count = 4;
    for (int j = 0; j < 4; ++j) {
      const auto sample = state(10 * k + j);
      turn.samples.insert(turn.samples.end(), sample.begin(), sample.end());
    }
    turn.section = state(k);
    turn.hits = k;
    turn.contact_fraction = 0.1 * k;
    turn.peak_displacement_m = k == 2 ? 7 : 1;
    turn.peak_contact_force_n = k == 5 ? 9 : 2;
    record.add(turn);
  }

  const Window older = record.window(0), newer = record.window(1);
  EXPECT_EQ(older.turns, 3);
  EXPECT_EQ(older.samples_per_revolution, 4);
  EXPECT_EQ(older.clearance_m, 2e-3);
  EXPECT_EQ(older.states, 4);
  ASSERT_EQ(older.displacement_m.size(), 12u);
  ASSERT_EQ(newer.displacement_m.size(), 12u);
  ASSERT_EQ(record.displacement_m().size(), 24u);
  // x and y are in metres, whereas states are in units of the clearance.
  EXPECT_DOUBLE_EQ(older.displacement_m[0].real(), 2e-3 * 10);
  EXPECT_DOUBLE_EQ(older.displacement_m[11].imag(), 2e-3 * 330);
  EXPECT_DOUBLE_EQ(newer.displacement_m[0].real(), 2e-3 * 40);
  // Sections 0 to 3, then 3 to 6.
  ASSERT_EQ(older.section.size(), 16u);
  EXPECT_EQ(older.section.front(), 0);
  EXPECT_EQ(older.section.back(), 3000);
  ASSERT_EQ(newer.section.size(), 16u);
  EXPECT_EQ(newer.section.front(), 3);
  EXPECT_EQ(newer.section.back(), 6000);
  EXPECT_EQ(together(older.contact).hits, 1 + 2 + 3);
  EXPECT_EQ(together(newer.contact).hits, 4 + 5 + 6);
  EXPECT_NEAR(together(older.contact).contact_fraction, 0.2, 1e-15);
  EXPECT_NEAR(together(newer.contact).contact_fraction, 0.5, 1e-15);
  EXPECT_EQ(together(older.contact).peak_displacement_m, 7);
  EXPECT_EQ(together(newer.contact).peak_displacement_m, 1);
  EXPECT_EQ(together(older.contact).peak_contact_force_n, 2);
  EXPECT_EQ(together(newer.contact).peak_contact_force_n, 9);
}

/// A mass that oscillates along x, released at 1e-4 m, a tenth of the clearance. Without damping one period
/// takes `period_turns` revolutions.
scene::Scene swinging(double period_turns, double damping_ratio = 0) {
  const double w = 2 * std::numbers::pi / period_turns;
  scene::Scene scene = test::one_mass_scene(1, w * w, 2 * damping_ratio * w, 1, 1e-3);
  scene.displacement_m << 1e-4, 0;
  return scene;
}

TEST(RecordSettled, HoldsTheSamplesOfTheTurnsBehindThoseThatPass) {
  integrate::exact::modes::ModeCache modes;
  const auto record = record_settled(
      swinging(7.3), {}, modes, {.settling = {.most_turns = 5}, .turns = 2, .samples_per_revolution = 16});
  ASSERT_TRUE(record);
  EXPECT_EQ(record->passed, 5);
  EXPECT_FALSE(record->touched);
  ASSERT_EQ(record->displacement_m.size(), 32u);
  for (int k = 0; k < 32; ++k) {
    const auto z = record->displacement_m[static_cast<std::size_t>(k)];
    EXPECT_NEAR(z.real(), 1e-4 * std::cos(2 * std::numbers::pi * (5 + k / 16.0) / 7.3), 1e-12) << k;
    EXPECT_NEAR(z.imag(), 0, 1e-15);
  }
  EXPECT_NEAR(record->end[0], 0.1 * std::cos(2 * std::numbers::pi * 7 / 7.3), 1e-9);
}

TEST(RecordSettled, IsSettledWhereTheSectionReturns) {
  integrate::exact::modes::ModeCache modes;
  const auto turns = [&](const Settling& settling) {
    const auto record = record_settled(swinging(3), {}, modes, {.settling = settling});
    return record ? record->passed : -1;
  };
  EXPECT_EQ(turns({.most_turns = 50, .order = 3}), 3);
  EXPECT_EQ(turns({.most_turns = 50, .order = 3, .fewest_turns = 20}), 20);
  EXPECT_EQ(turns({.most_turns = 50, .order = 2}), 50);
  EXPECT_EQ(turns({.most_turns = 50}), 50);
}

TEST(RecordSettled, ADampedMotionReturnsOnceItHasDiedAway) {
  integrate::exact::modes::ModeCache modes;
  const auto record =
      record_settled(swinging(3, 0.05), {}, modes, {.settling = {.most_turns = 500, .order = 3}});
  ASSERT_TRUE(record);
  // Displacement in clearances, and its derivative per radian of shaft angle, from the closed form.
  const double w = 2 * std::numbers::pi / 3, decay = 0.05 * w, damped = std::sqrt(w * w - decay * decay);
  const auto state = [&](long turns) {
    const auto t = static_cast<double>(turns);
    return std::complex(
        0.1 * std::exp(-decay * t) * (std::cos(damped * t) + decay / damped * std::sin(damped * t)),
        -0.1 * std::exp(-decay * t) * w * w / damped * std::sin(damped * t) / (2 * std::numbers::pi));
  };
  long settled = 3;
  const auto returns = [&](long turns) {
    const auto step = state(turns) - state(turns - 3);
    return std::max(std::abs(step.real()), std::abs(step.imag())) <= 1e-5;
  };
  while (!returns(settled)) ++settled;
  EXPECT_GT(settled, 30);
  EXPECT_EQ(record->passed, settled);
}

TEST(RecordSettled, GivesUpAMotionThatTouchesNothingAnyMore) {
  integrate::exact::modes::ModeCache modes;
  const Wanted wanted{.settling = {.most_turns = 20, .longest_flight = 10}, .turns = 1};
  EXPECT_FALSE(record_settled(swinging(3), {}, modes, wanted));
  const Wanted shorter{.settling = {.most_turns = 10, .longest_flight = 10}, .turns = 1};
  EXPECT_TRUE(record_settled(swinging(3), {}, modes, shorter));
}

TEST(RecordSettled, GivesUpWhereWorkIsUsedUpWhileItSettlesOrIsRecorded) {
  integrate::exact::modes::ModeCache modes;
  EXPECT_FALSE(
      record_settled(swinging(3), {}, modes, {.settling = {.most_turns = 1, .most_work = 0}, .turns = 0}));
  EXPECT_FALSE(record_settled(swinging(3), {}, modes, {.settling = {.most_work = 0}, .turns = 1}));
}

TEST(RecordSettled, BeginsAtAGivenSectionAndShowsEveryTurn) {
  integrate::exact::modes::ModeCache modes;
  const std::vector<double> start{0.2, 0, 0, 0};
  std::vector<long> left;
  std::vector<double> begins;
  const auto record = record_settled(
      swinging(4), {}, modes,
      {.start = start, .turns = 3, .samples_per_revolution = 8, .take = [&](const RecordedTurn& turn) {
         left.push_back(turn.left);
         begins.push_back(turn.begin[0]);
         EXPECT_EQ(turn.report.sample_count, 8);
       }});
  ASSERT_TRUE(record);
  EXPECT_TRUE(record->displacement_m.empty());
  EXPECT_EQ(left, (std::vector<long>{3, 2, 1}));
  ASSERT_EQ(begins.size(), 3u);
  EXPECT_EQ(begins[0], 0.2);
  EXPECT_NEAR(begins[1], 0, 1e-9);
  EXPECT_NEAR(begins[2], -0.2, 1e-9);
}

TEST(RecordSettled, TheFactsAreThoseOfTheRecordedTurns) {
  const scene::Cell cell = test::cell_of({});
  integrate::exact::modes::ModeCache modes;
  const auto record = record_settled(
      cell.scene, {}, modes,
      {.settling = {.most_turns = 60}, .turns = 12, .samples_per_revolution = 32, .peaks = true});
  ASSERT_TRUE(record);
  const integrate::run::Run run = integrate::start(cell.scene, {}, modes);
  integrate::run::TurnReport turn;
  int hits = 0;
  double contact = 0, force_n = 0;
  for (int k = 0; k < 72; ++k) {
    ASSERT_EQ(run.advance({.peaks = true}, turn), integrate::run::Outcome::ok);
    if (k < 60) continue;
    hits += turn.hits;
    contact += turn.contact_fraction / 12;
    force_n = std::max(force_n, turn.peak_contact_force_n);
  }
  EXPECT_EQ(record->contact.hits, hits);
  EXPECT_EQ(record->touched, hits > 0 || contact > 0);
  EXPECT_NEAR(record->contact.contact_fraction, contact, 1e-9);
  EXPECT_NEAR(record->contact.peak_contact_force_n, force_n, 1e-6 * force_n);
}

TEST(RecordSettled, GivesUpAMotionThatPressesTooHardAfterItsStart) {
  const scene::Cell cell = test::cell_of({});
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(cell.scene, {}, modes);
  integrate::run::TurnReport turn;
  double first_n = 0, looked_n = 0;
  for (int k = 0; k < 40; ++k) {
    ASSERT_EQ(run.advance({.peaks = true}, turn), integrate::run::Outcome::ok);
    first_n = std::max(first_n, k < 16 ? turn.peak_contact_force_n : 0);
    if (k == 16 || k == 32) looked_n = std::max(looked_n, turn.peak_contact_force_n);
  }
  ASSERT_GT(looked_n, 0);
  EXPECT_GT(first_n, 1.01 * looked_n);
  for (const double share : {0.99, 1.01}) {
    const auto record =
        record_settled(cell.scene, {}, modes,
                       {.settling = {.most_turns = 40, .most_force_n = share * looked_n}, .turns = 1});
    EXPECT_EQ(record.has_value(), share > 1);
  }
}

TEST(RecordSettled, QuietSamplesAreTheClosedForm) {
  const scene::Cell cell = test::cell_of({});
  const auto samples = quiet_samples(cell, 24);
  ASSERT_EQ(samples.size(), 24u);
  // A single mass point that whirls on a circle about its mean.
  std::complex<double> mean = 0;
  for (const auto& z : samples) mean += z / 24.0;
  for (const auto& z : samples)
    EXPECT_NEAR(std::abs(z - mean), std::abs(samples[0] - mean), 1e-9 * std::abs(samples[0]));
  EXPECT_NEAR(samples[0].real(), cell.quiet.displacement(0)(0), 1e-18);
}

}  // namespace

}  // namespace rubsweep::response::motion
