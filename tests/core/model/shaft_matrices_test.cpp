#include "rubsweep/core/model/shaft_matrices.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "core/structure/hand_matrices.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/balance.hpp"
#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::model {
namespace {

TEST(ShaftMatrices, WeighWhatMovesAlongY) {
  ShaftMatrices matrices = structure::disc_and_bracket();
  matrices.mass(1, 3) = matrices.mass(3, 1) = 0.5;
  EXPECT_EQ(weight_kg(matrices), Eigen::Vector4d(0, 2.5, 0, 5.5));
  EXPECT_EQ(rotor_mass_kg(matrices), 2.5) << "without the body beside the shaft";
  matrices.degrees_of_freedom[1].weight_kg = 1.75;
  EXPECT_EQ(weight_kg(matrices), Eigen::Vector4d(0, 1.75, 0, 5.5));
  EXPECT_EQ(shaft_length_m(matrices), 0.5);
}

TEST(ShaftMatrices, CountTheUnbalanceOfANodeOnce) {
  ShaftMatrices matrices = structure::disc_and_bracket();
  EXPECT_EQ(unbalanced_mass_kg(matrices), 2);
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  matrices.unbalance_kg(0) = {unknown, unknown};
  EXPECT_EQ(unbalanced_mass_kg(matrices), 2);
  matrices.unbalance = {{"disc", 4, 0.25, 90}};
  EXPECT_EQ(unbalanced_mass_kg(matrices), 3);
}

TEST(ShaftMatrices, OfAMachineGiveItsMassesAndLength) {
  Machine machine;
  machine.rotor.emplace<RotorKit>().matrices = std::make_shared<ShaftMatrices>(structure::book_rotor());
  // Mass of the shaft of 1.5 m length and 50 mm diameter, and of both discs.
  const double shaft_kg = 7810 * 3.14159265358979323846 / 4 * 0.05 * 0.05 * 1.5;
  const double discs_kg = 32.58972765304033 + 51.52526111152619;
  EXPECT_NEAR(rotor_mass_kg(machine), shaft_kg + discs_kg, 1e-12 * discs_kg);
  EXPECT_NEAR(unbalanced_mass_kg(machine), discs_kg, 1e-13 * discs_kg);
  EXPECT_EQ(shaft_length_m(*kit_of(machine)), 1.5);
}

std::string refused(auto change) {
  ShaftMatrices matrices = structure::disc_and_bracket();
  change(matrices);
  return message_of<ConfigError>([&] { validate(matrices, "rotor."); });
}

TEST(ShaftMatrices, AreCheckedForUsersOfTheLibrary) {
  EXPECT_NO_THROW(validate(structure::disc_and_bracket(), "rotor."));
  EXPECT_EQ(refused([](auto& m) { m.stiffness.setZero(3, 3); }),
            "rotor.stiffness: is 3 x 3, allowed: 4 x 4, as many as degrees_of_freedom");
  EXPECT_EQ(refused([](auto& m) { m.damping(0, 0) = INFINITY; }),
            "rotor.damping: holds a number that is not finite, allowed: finite ones");
  EXPECT_EQ(refused([](auto& m) { m.unbalance_kg.setZero(2); }),
            "rotor.unbalance: has 2 numbers, allowed: 4, as many as degrees_of_freedom");
  EXPECT_EQ(refused([](auto& m) { m.degrees_of_freedom[1] = m.degrees_of_freedom[0]; }),
            "rotor.degrees_of_freedom: x of node disc stands twice, allowed: each once");
  EXPECT_EQ(refused([](auto& m) { m.degrees_of_freedom[0].position_m = -1; }),
            "rotor.degrees_of_freedom.position_m: -1 is out of range, allowed: a number >= 0 and <= 10000");
  EXPECT_EQ(refused([](auto& m) {
              m.degrees_of_freedom[0].position_m.reset(), m.degrees_of_freedom[1].position_m.reset();
            }),
            "rotor.degrees_of_freedom: no node is on the shaft, allowed: a position_m for at least one");
  EXPECT_EQ(refused([](auto& m) {
              m.unbalance = {{"bracket", 1, 1, 0}};
            }),
            "rotor.unbalance.node: 'bracket' is not on the shaft, allowed: a node of degrees_of_freedom with "
            "a position_m");
}

TEST(ShaftMatrices, ExcludePartsThatTheyStandFor) {
  RotorKit kit;
  kit.matrices = std::make_shared<ShaftMatrices>(structure::disc_and_bracket());
  EXPECT_NO_THROW(validate(kit, "rotor."));
  kit.discs = {{0.1, 1, 0, 0}};
  EXPECT_EQ(message_of<ConfigError>([&] { validate(kit, "rotor."); }),
            "rotor.discs: is given beside matrices, allowed: nothing");
}

}  // namespace
}  // namespace rubsweep::model
