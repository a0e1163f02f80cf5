#include "rubsweep/maps/config/keys/fields.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/model/range.hpp"

namespace rubsweep::config::keys {
namespace {

struct Part {
  double mass_kg = model::required;
  double phase_deg = 1.5;
  std::optional<double> mass_y_kg = std::nullopt;

  static void visit_fields(auto& self, auto&& visit) {
    visit("mass_kg", self.mass_kg, model::positive);
    visit("phase_deg", self.phase_deg, model::any_finite);
    visit("mass_y_kg", self.mass_y_kg, model::not_negative);
  }
};

TEST(Fields, RangesAndDefaultsAreTheStructs) {
  const auto keys =
      fields_of<Part>({{"mass_kg", "mass"}, {"phase_deg", "phase"}, {"mass_y_kg", "mass in y", "mass_kg"}});
  ASSERT_EQ(keys.size(), 3u);
  EXPECT_TRUE(keys[0].required);
  EXPECT_TRUE(keys[0].form.range.low_open);
  EXPECT_EQ(keys[0].meaning, "mass");
  EXPECT_FALSE(keys[1].required);
  EXPECT_EQ(keys[1].fallback, "1.5");
  EXPECT_FALSE(keys[2].required);
  EXPECT_EQ(keys[2].fallback, "mass_kg");
}

TEST(Fields, AFieldWithoutMeaningOrAMeaningWithoutFieldIsAFault) {
  EXPECT_THROW(fields_of<Part>({{"mass_kg", "mass"}, {"phase_deg", "phase"}}), std::logic_error);
  EXPECT_THROW(fields_of<Part>({{"mass_kg", "a"}, {"phase_deg", "b"}, {"mass_y_kg", "c"}, {"gone_m", "d"}}),
               std::logic_error);
}

}  // namespace
}  // namespace rubsweep::config::keys
