#include "rubsweep/maps/config/keys/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::config::keys {
namespace {

enum class Side { left, right };
constexpr Words<Side, 2> sides{{"left", "right"}, {Side::left, Side::right}};

struct Part {
  double mass_kg = model::required;
  double phase_deg = 1.5;
  std::optional<double> mass_y_kg = std::nullopt;
  int count = 3;
  long levels = 0;
  Side side = Side::right;
  std::optional<int> modes;

  static void visit_fields(auto& self, auto&& visit) {
    using model::key, model::newer_key;
    visit("mass_kg", self.mass_kg, key(model::positive, "mass"));
    visit("phase_deg", self.phase_deg, newer_key(model::any_finite, "phase"));
    visit("mass_y_kg", self.mass_y_kg, key(model::not_negative, "mass in y", "mass_kg"));
    visit("count", self.count, key(model::IntegerRange{2, 8, true}, "count"));
    visit("levels", self.levels, key(model::IntegerRange{1, 12}, "levels", model::needed));
    visit("side", self.side, key(sides, "side"));
    visit("modes", self.modes, key(model::IntegerOr{{1, 40}, "auto"}, "modes", "auto"));
  }
};

TEST(Table, RangesAndDefaultsAreTheStructs) {
  const auto keys = keys_of<Part>();
  ASSERT_EQ(keys.size(), 7u);
  EXPECT_TRUE(keys[0].required);
  EXPECT_TRUE(keys[0].form.range.low_open);
  EXPECT_EQ(keys[0].meaning, "mass");
  EXPECT_EQ(keys[0].since, "0.1.0");
  EXPECT_FALSE(keys[1].required);
  EXPECT_EQ(keys[1].fallback, "1.5");
  EXPECT_EQ(keys[1].since, "0.2.0");
  EXPECT_FALSE(keys[2].required);
  EXPECT_EQ(keys[2].fallback, "mass_kg");
}

TEST(Table, IntegersAndWordsHaveTheirDefaultsToo) {
  const auto keys = keys_of<Part>();
  EXPECT_EQ(allowed(keys[3].form), "even integer, 2 to 8");
  EXPECT_EQ(keys[3].fallback, "3");
  EXPECT_TRUE(keys[4].required);
  EXPECT_EQ(keys[4].fallback, "");
  EXPECT_EQ(allowed(keys[5].form), "left or right");
  EXPECT_EQ(keys[5].fallback, "right");
  EXPECT_EQ(allowed(keys[6].form), "auto, or an integer from 1 to 40");
  EXPECT_EQ(keys[6].fallback, "auto");
}

struct Whole {
  static void visit_keys(auto&, auto& keys) {
    const Part part;
    keys.field("side", part.side, model::key(sides, "side"));
    keys.map("body", "its body", [&](auto& body) {
      body.beside("side", {"left"}, false,
                  [&] { body.field("mass_kg", part.mass_kg, model::key(model::positive, "mass")); });
    });
  }
};

TEST(Table, MapsAndConditionsAreTold) {
  const auto keys = keys_of<Whole>();
  ASSERT_EQ(keys.size(), 2u);
  EXPECT_TRUE(keys[1].required);
  ASSERT_EQ(keys[1].form.keys.size(), 1u);
  EXPECT_EQ(keys[1].form.keys[0].when.selector, "side");
  EXPECT_EQ(keys[1].form.keys[0].when.words, std::vector<std::string>{"left"});
}

struct Other {
  double force_n = model::required, angle_deg = 0;

  static void visit_fields(auto& self, auto&& visit) {
    visit("force_n", self.force_n, model::key(model::positive, "force"));
    visit("angle_deg", self.angle_deg, model::key(model::any_finite, "angle"));
  }
};

TEST(Table, AWayNeedsItsKeysWithoutDefault) {
  const Choice choice = choice_of({keys_of<Other>(), {must("mode", integer(1, 2), "mode")}});
  ASSERT_EQ(choice.ways.size(), 2u);
  EXPECT_EQ(choice.ways[0].required, std::vector<std::string>{"force_n"});
  EXPECT_EQ(choice.ways[0].optional, std::vector<std::string>{"angle_deg"});
  EXPECT_EQ(choice.ways[1].required, std::vector<std::string>{"mode"});
}

}  // namespace
}  // namespace rubsweep::config::keys
