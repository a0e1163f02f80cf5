#include "rubsweep/fit/fit_problem.hpp"

#include <gtest/gtest.h>

namespace rubsweep::fit {
namespace {

TEST(FitProblem, TakesANumberFromTheParametersWhereItIsOne) {
  MachineFit problem;
  problem.parameters = {{.name = "rotor.damping_ratio"}, {.name = mark_name}};
  const Eigen::Vector2d values(0.02, 40);
  EXPECT_EQ(value_named(problem, values, mark_name, 7), 40);
  EXPECT_EQ(value_named(problem, values, hit_name, 7), 7);
}

}  // namespace
}  // namespace rubsweep::fit
