#include "rubsweep/core/integrate/run/coordinates.hpp"

#include <gtest/gtest.h>

namespace rubsweep::integrate::run {
namespace {

TEST(CoordinatesWith, UsualNumbersAreConstantsAndOthersAreNot) {
  for (const int coordinates : {2, 4, 6}) {
    EXPECT_EQ(with_coordinates(coordinates, [](auto n) { return static_cast<int>(n()); }), coordinates);
  }
  for (const int coordinates : {3, 5, 8}) {
    EXPECT_EQ(with_coordinates(coordinates, [](auto n) { return static_cast<int>(n()); }), Eigen::Dynamic);
  }
}

}  // namespace
}  // namespace rubsweep::integrate::run
