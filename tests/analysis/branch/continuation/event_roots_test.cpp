#include "rubsweep/analysis/branch/continuation/event_roots.hpp"

#include <gtest/gtest.h>

namespace rubsweep::branch::continuation {
namespace {

/// Numbers from 0 to 2, each at its own distance.
struct Line {
  static double length() { return 2; }
  static double required_at(double s) { return s; }
};

TEST(EventRoots, TheRootOfATestFunctionIsEnclosed) {
  const auto root = root_on(Line{}, [](double x) { return x * x * x - 2; });
  ASSERT_TRUE(root);
  EXPECT_LE(root->high - root->low, event_width);
  EXPECT_LE(root->low * root->low * root->low, 2);
  EXPECT_GE(root->high * root->high * root->high, 2);
}

TEST(EventRoots, NoRootWithoutAChangeOfSign) {
  EXPECT_FALSE(root_on(Line{}, [](double x) { return (x - 1) * (x - 1) - 0.1; }));
}

TEST(EventRoots, ChangesOneAfterTheOther) {
  const auto first = change_on(Line{}, 0, 0.0, [](double x) { return x > 0.3; });
  EXPECT_LE(first.at.high - first.at.low, event_width);
  EXPECT_LE(first.before, 0.3);
  EXPECT_GT(first.behind, 0.3);
  EXPECT_NEAR(first.behind, 0.3, event_width);
  const auto second = change_on(Line{}, first.at.high, first.behind, [](double x) { return x > 1.7; });
  EXPECT_NEAR(second.behind, 1.7, event_width);
}

}  // namespace
}  // namespace rubsweep::branch::continuation
