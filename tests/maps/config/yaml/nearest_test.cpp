#include "rubsweep/maps/config/yaml/nearest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace rubsweep::config::yaml {
namespace {

constexpr std::array<std::string_view, 5> names{"mass_kg", "stiffness_n_per_m", "restitution",
                                                "restitution_delivered", "kind"};

TEST(Nearest, FindsAMisspeltName) {
  EXPECT_EQ(nearest("mas_kg", names), "mass_kg");
  EXPECT_EQ(nearest("mass_gk", names), "mass_kg");
  EXPECT_EQ(nearest("stifness_n_per_m", names), "stiffness_n_per_m");
  EXPECT_EQ(nearest("resitution_deliverd", names), "restitution_delivered");
  EXPECT_EQ(nearest("kin", names), "kind");
  EXPECT_EQ(nearest("kindd", names), "kind");
}

TEST(Nearest, FindsANameWithoutItsUnit) {
  EXPECT_EQ(nearest("mass", names), "mass_kg");
  EXPECT_EQ(nearest("stiffness", names), "stiffness_n_per_m");
  constexpr std::array<std::string_view, 2> longest_first{"speed_of_sound_m_per_s", "speed_hz"};
  EXPECT_EQ(nearest("speed", longest_first), "speed_hz");
}

TEST(Nearest, PrefersTheSmallerDistanceThenTheFirstListed) {
  constexpr std::array<std::string_view, 3> similar{"casings", "casino", "casing"};
  EXPECT_EQ(nearest("casin", similar), "casino");
  EXPECT_EQ(nearest("casingss", similar), "casings");
}

TEST(Nearest, FindsNothingFarAway) {
  EXPECT_EQ(nearest("gravity", names), std::nullopt);
  EXPECT_EQ(nearest("", names), std::nullopt);
  EXPECT_EQ(nearest(std::string(100'000, 'm'), names), std::nullopt);
  EXPECT_EQ(nearest("kind", {}), std::nullopt);
}

}  // namespace
}  // namespace rubsweep::config::yaml
