#include "rubsweep/core/structure/matrix_problems.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/structure/hand_matrices.hpp"

namespace rubsweep::structure {
namespace {

using model::Direction;

/// Text "key: wrong" for every problem.
std::string problem_of(const model::ShaftMatrices& matrices) {
  std::string all;
  for (const MatrixProblem& problem : problems_of(matrices)) {
    if (!all.empty()) all += "; ";
    all += problem.key + ": " + problem.wrong;
  }
  return all.empty() ? "none" : all;
}

TEST(MatrixProblems, NameWhatNoBeamShaftHas) {
  const auto with = [](auto change) {
    model::ShaftMatrices matrices = disc_and_bracket();
    change(matrices);
    return problem_of(matrices);
  };
  EXPECT_EQ(with([](auto&) {}), "none");
  EXPECT_EQ(with([](auto& m) { m.mass(0, 2) = 1; }),
            "mass: is not symmetric by 1 at row 1 (x of node disc), column 3 (x of node bracket)");
  EXPECT_EQ(
      with([](auto& m) { m.mass(0, 1) = m.mass(1, 0) = 0.5; }),
      "mass: couples the motion in x and in y by 0.5 at row 1 (x of node disc), column 2 (y of node disc)");
  EXPECT_EQ(with([](auto& m) { m.mass(0, 2) = m.mass(2, 0) = 4; }),
            "mass: is not positive definite: some motion has no kinetic energy");
  EXPECT_EQ(with([](auto& m) { m.mass(3, 3) = -5; }),
            "mass: has -5 on its diagonal at row 4 (y of node bracket), column 4 (y of node bracket)");
  EXPECT_EQ(with([](auto& m) { m.mass.setZero(); }), "mass: is zero");
  EXPECT_EQ(
      with([](auto& m) { m.stiffness(0, 2) = -1e4; }),
      "stiffness: is not symmetric within one plane by 10000 at row 1 (x of node disc), column 3 (x of node "
      "bracket)");
  EXPECT_EQ(with([](auto& m) { m.damping(1, 3) = 7; }),
            "damping: is not symmetric within one plane by 7 at row 2 (y of node disc), column 4 (y of node "
            "bracket)");
  EXPECT_EQ(with([](auto& m) { m.gyroscopic(0, 1) = m.gyroscopic(1, 0) = 0.3; }),
            "gyroscopic: is not skew-symmetric by 0.6 at row 1 (x of node disc), column 2 (y of node disc)");
  EXPECT_EQ(
      with([](auto& m) { m.gyroscopic(0, 2) = 0.3, m.gyroscopic(2, 0) = -0.3; }),
      "gyroscopic: acts within one plane by 0.3 at row 1 (x of node disc), column 3 (x of node bracket)");
  EXPECT_EQ(with([](auto& m) { m.gyroscopic(0, 3) = 0.3, m.gyroscopic(3, 0) = -0.3; }),
            "gyroscopic: turns x into y otherwise than y into x, by 0.3 at row 3 (x of node bracket), column "
            "2 (y of "
            "node disc)");
  EXPECT_EQ(with([](auto& m) {
              m.unbalance_kg(1) = {0, 2};
            }),
            "unbalance: does not turn with the shaft at node disc: y does not lag a quarter turn behind x");
  EXPECT_EQ(
      with([](auto& m) { m.degrees_of_freedom[3].direction = Direction::ry; }),
      "degrees_of_freedom: node bracket has x and no y; degrees_of_freedom: node bracket has ry and no rx");
}

TEST(MatrixProblems, AreTwoPlacesOfANodeAndAShaftWithoutDeflection) {
  model::ShaftMatrices two = empty_matrices(freedoms_at({0.3}));
  two.degrees_of_freedom[1].position_m = 0.4;
  const auto problems = problems_of(two);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].wrong, "gives node 1 two positions");
  EXPECT_EQ(problems[0].degree_of_freedom, 1U);
  const auto tilting = empty_matrices({{"a", Direction::rx, 0.3, {}}, {"a", Direction::ry, 0.3, {}}});
  EXPECT_EQ(problem_of(tilting), "degrees_of_freedom: node a is on the shaft and has neither x nor y");
}

TEST(MatrixProblems, AreNotWhatRoundingLeavesNorDegreesOfFreedomWithoutMass) {
  model::ShaftMatrices matrices = disc_and_bracket();
  matrices.stiffness(0, 2) *= 1 + 1e-12;
  matrices.mass(2, 2) = matrices.mass(3, 3) = 0;
  EXPECT_EQ(problem_of(matrices), "none");
}

TEST(MatrixProblems, FindWhereAMatrixIsNotSymmetric) {
  const Asymmetry found = asymmetry_of(disc_and_bracket().stiffness);
  EXPECT_EQ(found.difference, 7e3);
  EXPECT_EQ(found.row, 1);
  EXPECT_EQ(found.column, 0);
}

TEST(MatrixProblems, ShaftThatTurnsFromYToXHasGyroscopicNumbersOfTheOtherSign) {
  model::ShaftMatrices rotor = book_rotor();
  EXPECT_EQ(problem_of(rotor), "none");
  rotor.gyroscopic = -rotor.gyroscopic.eval();
  EXPECT_EQ(problem_of(rotor), "gyroscopic: has the sign of a shaft that turns from y to x");
  // A single disc, whose moments of inertia are in the rows of its rotations.
  rotor.gyroscopic.setZero();
  rotor.gyroscopic(10, 11) = -0.3, rotor.gyroscopic(11, 10) = 0.3;
  EXPECT_EQ(problem_of(rotor), "gyroscopic: has the sign of a shaft that turns from y to x");
}

}  // namespace
}  // namespace rubsweep::structure
