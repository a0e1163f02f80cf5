#include "rubsweep/config/place_of_key.hpp"

#include "config/support.hpp"

namespace rubsweep::config {
namespace {

TEST(PlaceOfKey, IsThatOfItsValue) {
  const std::filesystem::path file = std::filesystem::path(CONFIG_TEST_DATA) / "minimal.yaml";
  const std::string name = file.string();
  EXPECT_EQ(place_of_key(file, {}, "rotor.mass_kg"), name + ":2:34");
  EXPECT_EQ(place_of_key(file, {}, "stops.0.angle_deg"), name + ":5:16");
  EXPECT_EQ(place_of_key(file, {"rotor.mass_kg=2"}, "rotor.mass_kg"), "--set rotor.mass_kg=2");
  EXPECT_EQ(place_of_key(file, {}, "kick.force_n"), name);
}

}  // namespace
}  // namespace rubsweep::config
