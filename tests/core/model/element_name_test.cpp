#include "rubsweep/core/model/element_name.hpp"

#include <gtest/gtest.h>

namespace rubsweep::model {
namespace {

RotorKit with_support(const std::string& name) {
  RotorKit kit;
  kit.supports.resize(2);
  kit.supports[1].name = name;
  return kit;
}

TEST(ElementName, ATypedSupportHasTheKeyOfTheConfigurationWhateverItsName) {
  EXPECT_EQ(support_path(with_support(""), 1), "rotor.supports.1");
  EXPECT_EQ(support_path(with_support("drive_end"), 1), "rotor.supports.1");
  EXPECT_EQ(support_name(with_support("drive_end"), 1), "drive_end");
}

TEST(ElementName, ASupportOfAFileHasItsNameThere) {
  RotorKit kit = with_support("SealElement_Labyrinth_2");
  kit.from_file = true;
  EXPECT_EQ(support_path(kit, 1), "rotor.file.SealElement_Labyrinth_2");
  EXPECT_EQ(support_name(kit, 1), "Labyrinth_2");
  kit.supports[1].name = "Labyrinth";
  EXPECT_EQ(support_name(kit, 1), "Labyrinth") << "without a class before the tag";
}

TEST(ElementName, WithoutANameThereAreNoBrackets) {
  EXPECT_EQ(in_brackets("Drive end"), " (Drive end)");
  EXPECT_EQ(in_brackets(""), "");
}

TEST(ElementName, ASensorHasItsNameBeforeItsDirection) {
  EXPECT_EQ(sensor_label(2, "DE x", 37.5), "2 (DE x, 37.5 deg)");
  EXPECT_EQ(sensor_label(0, "", 90), "0 (90 deg)");
  Machine machine;
  EXPECT_EQ(sensor_name(machine, 0), "") << "the directions x and y of a Jeffcott rotor";
  RotorKit kit;
  kit.sensors = {{.name = "DE x"}};
  machine.rotor = kit;
  EXPECT_EQ(sensor_name(machine, 0), "DE x");
  EXPECT_EQ(sensor_name(machine, 1), "");
}

TEST(ElementName, AListOfNamesMayBeShorter) {
  EXPECT_EQ(name_at({"seal"}, 0), "seal");
  EXPECT_EQ(name_at({"seal"}, 1), "");
}

}  // namespace
}  // namespace rubsweep::model
