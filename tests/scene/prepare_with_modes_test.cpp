#include "rubsweep/scene/prepare_with_modes.hpp"

#include <gtest/gtest.h>

#include "rubsweep/error.hpp"
#include "scene/table_machine.hpp"

namespace rubsweep::scene {
namespace {

TEST(PrepareWithModes, IsTheMachineThatSaysSoManyModes) {
  for (const int modes : {1, 2}) {
    const PreparedMachine expected = prepare_machine(table_machine(modes)),
                          found = prepare_with_modes(table_machine(3), modes);
    EXPECT_EQ(found.assembly.system.mass, expected.assembly.system.mass) << modes;
    EXPECT_EQ(found.assembly.system.stiffness, expected.assembly.system.stiffness) << modes;
    EXPECT_EQ(found.assembly.system.damping, expected.assembly.system.damping) << modes;
  }
}

TEST(PrepareWithModes, KeepsTheirNumberAtEverySpeed) {
  const PreparedMachine open = prepare_with_modes(table_machine(std::nullopt), 1);
  for (const double speed_hz : table_speeds_hz)
    EXPECT_EQ(prepared_at(open, speed_hz).assembly.system.coordinates(),
              prepared_at(prepare_machine(table_machine(1)), speed_hz).assembly.system.coordinates());
}

TEST(PrepareWithModes, RefusesWhatIsNotAllowed) {
  model::Machine machine = table_machine();
  model::kit_of(machine)->discs.front().mass_kg = -1;
  EXPECT_THROW(prepare_with_modes(machine, 1), ConfigError);
}

}  // namespace
}  // namespace rubsweep::scene
