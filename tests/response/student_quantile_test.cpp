#include "rubsweep/response/student_quantile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rubsweep::response {
namespace {

TEST(StudentQuantile, HasClosedFormsForOneAndTwoDegreesOfFreedom) {
  EXPECT_NEAR(student_quantile(1), std::tan(std::numbers::pi * 0.495), 1e-11);
  EXPECT_NEAR(student_quantile(2), 0.99 / std::sqrt(2 * 0.995 * 0.005), 1e-13);
}

TEST(StudentQuantile, IsThatOfPrintedTables) {
  EXPECT_NEAR(student_quantile(6), 3.7074, 5e-5);
  EXPECT_NEAR(student_quantile(7), 3.4995, 5e-5);
  EXPECT_NEAR(student_quantile(30), 2.7500, 5e-5);
}

}  // namespace
}  // namespace rubsweep::response
