#include "rubsweep/measurement/diagnose/answer/answer_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "small_answer.hpp"

namespace rubsweep::diagnose::answer {
namespace {

TEST(AnswerTables, ListProbabilities) {
  EXPECT_EQ(probabilities_csv(small_answer()),
            "candidate,probability\none_side,0.9\nannular,0.06\nnone_of_these,0.04\n");
}

TEST(AnswerTables, LayTheMotionsSideBySide) {
  const std::string plane = orbits_csv(small_answer(), small_motion(), true),
                    probe = orbits_csv(small_answer(), small_motion(), false);
  EXPECT_TRUE(
      plane.starts_with("turns,x_m,y_m,simulated_x_m,simulated_y_m\n0.000000,0.0001,5e-05,0.0001,5e-05\n"))
      << plane;
  EXPECT_TRUE(probe.starts_with("turns,x_m,simulated_x_m\n0.000000,0.0001,0.0001\n")) << probe;
  EXPECT_EQ(std::ranges::count(plane, '\n'), 1 + 4 * 64);
}

TEST(AnswerTables, ListTheLinesThatAreThere) {
  EXPECT_EQ(compared_lines_csv(small_answer(), small_motion()),
            "order,recorded_m,simulated_m\n0.5,5e-05,5e-05\n1,0.0001,0.0001\n");
}

}  // namespace
}  // namespace rubsweep::diagnose::answer
