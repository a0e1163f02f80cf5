#include "rubsweep/branch/orbits/settled_oval.hpp"

#include <gtest/gtest.h>

#include "response/annular_cell.hpp"
#include "rubsweep/response/settle.hpp"

namespace rubsweep::branch::orbits {
namespace {

std::optional<Eigen::VectorXd> oval_of(const scene::Cell& cell) {
  response::motion::Workspace workspace;
  response::motion::ResponseOptions options;
  options.max_revolutions = 60;
  options.window_revolutions = 24;  // two of them are within a run
  const response::SettledRun settled = response::settle(cell, {}, options, workspace);
  const Eigen::Map<const Eigen::VectorXd> section(settled.section.data(),
                                                  static_cast<Eigen::Index>(settled.section.size()));
  return oval_from(cell.scene, section, {}, options, workspace);
}

/// Its period is that of the comb that a long run shows, see RotatingProof; the state is a maximum of the
/// distance from the axis.
TEST(SettledOval, OfAnOvalItsFarthestPointAndPeriod) {
  const scene::Cell cell = response::testing::annular_cell(165, 0.6);
  const auto state = oval_of(cell);
  ASSERT_TRUE(state);
  ASSERT_EQ(state->size(), 9);
  const auto& map = cell.scene.structure.points[static_cast<std::size_t>(cell.scene.observed_point)].map;
  const Eigen::Vector2d z = map * state->head(4), v = map * state->segment(4, 4);
  EXPECT_NEAR(z.dot(v), 0, 1e-9);
  EXPECT_GT(z.norm(), 1) << "it touches";
  EXPECT_GT((*state)(8), 0);
}

TEST(SettledOval, NoneOfACircleNorWithoutSymmetry) {
  EXPECT_FALSE(oval_of(response::testing::annular_cell(80, 0.6)));
  EXPECT_FALSE(oval_of(response::testing::annular_cell(165, 0.6, 2e-4)));
}

}  // namespace
}  // namespace rubsweep::branch::orbits
