#include "rubsweep/core/structure/beam_mesh.hpp"

#include <gtest/gtest.h>

#include "core/structure/steel.hpp"

namespace rubsweep::structure {
namespace {

TEST(BeamMesh, HasNodesAtPartsAndTwoAtACoupling) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.4, 0.02), steel_segment(0.6, 0.03)};
  kit.elements = 4;
  kit.discs = {{.position_m = 0.3}};
  kit.couplings = {{.position_m = 0.8}};
  const BeamMesh mesh = mesh_of(kit, {0.3 + 1e-12, 1});
  // The longest element is 0.25 m: 0 to 0.3 and 0.4 to 0.8 are cut in two.
  const std::vector<double> expected{0, 0.15, 0.3, 0.4, 0.6, 0.8, 0.8, 1};
  ASSERT_EQ(mesh.node_position_m.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(mesh.node_position_m[i], expected[i], 1e-11) << i;
  ASSERT_EQ(mesh.elements.size(), 6U) << "none between the two ends of the coupling";
  EXPECT_EQ(mesh.elements[3].segment, &kit.shaft[1]);
  EXPECT_NEAR(mesh.elements[3].from, 0, 1e-15);
  EXPECT_NEAR(mesh.elements[3].to, 1.0 / 3, 1e-12);
  EXPECT_EQ(mesh.elements[5].first_node, 6U);
}

TEST(BeamMesh, TakesThePointsOfABow) {
  model::RotorKit kit;
  kit.bow = model::Bow{.shape = model::BowPoints{.position_m = {0.1, 0.7}, .deflection_m = {0, 1e-4}}};
  kit.sensors = {{.position_m = 0.2}};
  std::vector<double> places;
  add_places(kit, places);
  EXPECT_EQ(places, (std::vector<double>{0.2, 0.1, 0.7}));
}

}  // namespace
}  // namespace rubsweep::structure
