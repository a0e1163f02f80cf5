#include "rubsweep/core/response/motion/motion.hpp"

#include <gtest/gtest.h>

#include <array>

namespace rubsweep::response::motion {
namespace {

TEST(MotionContactFactsTogether, AddsHitsAveragesSharesAndTakesTheLargestPeaks) {
  const std::array<ContactFacts, 3> turns{
      {{1, 0.1, 2e-3, 50, 4e-5}, {0, 0, 3e-3, 0, 7e-5}, {2, 0.5, 1e-3, 80, 0}}};
  const ContactFacts all = together(turns);
  EXPECT_EQ(all.hits, 3);
  EXPECT_DOUBLE_EQ(all.contact_fraction, 0.2);
  EXPECT_EQ(all.peak_displacement_m, 3e-3);
  EXPECT_EQ(all.peak_contact_force_n, 80);
  EXPECT_EQ(all.peak_casing_displacement_m, 7e-5);
}

TEST(MotionContactFactsTogether, OfNoTurnIsNothing) {
  EXPECT_EQ(together({}).hits, 0);
  EXPECT_EQ(together({}).contact_fraction, 0);
}

}  // namespace

}  // namespace rubsweep::response::motion
