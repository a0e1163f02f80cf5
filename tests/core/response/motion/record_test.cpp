#include "rubsweep/core/response/motion/record.hpp"

#include <gtest/gtest.h>

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
  // x and y in metres: states are in units of the clearance.
  EXPECT_DOUBLE_EQ(older.displacement_m[0].real(), 2e-3 * 10);
  EXPECT_DOUBLE_EQ(older.displacement_m[11].imag(), 2e-3 * 330);
  EXPECT_DOUBLE_EQ(newer.displacement_m[0].real(), 2e-3 * 40);
  // Sections 0 to 3 and 3 to 6.
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

}  // namespace
}  // namespace rubsweep::response::motion
