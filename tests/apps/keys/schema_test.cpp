#include "keys/schema.hpp"

#include <gtest/gtest.h>

#include <string>

#include "rubsweep/core/model/range.hpp"
#include "rubsweep/maps/config/run_config.hpp"

/// agreement_test.py tests the verdicts of validators; these tests cover what validators do not see.
namespace rubsweep::apps {

using namespace config::keys;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Schema, DescriptionsHaveMeaningUnitRangeAndDefault) {
  const std::string schema =
      schema_of(map_of({may("length_m", number(model::positive), "its \"length\"", "2")}), "t");
  EXPECT_TRUE(holds(schema, R"("description":"its \"length\" [m]. Allowed: > 0. Default: 2")")) << schema;
  EXPECT_TRUE(holds(schema, R"("exclusiveMinimum":0,"maximum":1e+30)")) << schema;
  EXPECT_TRUE(holds(schema, R"("title":"t")"));
}

TEST(Schema, OverABaseNothingIsRequiredAndKeysMayBeTakenBack) {
  const std::string schema = schema_of(map_of({must("a_m", number({}), "length")}), "t");
  EXPECT_TRUE(
      holds(schema, R"("if":{"required":["base"]},"then":{"$ref":"#/definitions/configuration.over_base"})"));
  EXPECT_TRUE(holds(schema, R"("required":["a_m"])"));
  const std::string over = schema.substr(schema.find(R"("configuration.over_base":)"));
  EXPECT_FALSE(holds(over, R"("required":["a_m"])"));
  EXPECT_TRUE(holds(over, R"({"type":"null"})"));
}

TEST(Schema, NumbersOfTheRotorMayBeIntervals) {
  const Form inner = map_of({must("ratio", number(model::positive), "ratio")});
  const std::string rotor = schema_of(map_of({must("rotor", inner, "it")}), "t"),
                    stops = schema_of(map_of({must("stops", inner, "it")}), "t");
  EXPECT_TRUE(holds(
      rotor,
      R"("required":["value","from","to"],"properties":{"value":{"type":"number","exclusiveMinimum":0)"))
      << rotor;
  EXPECT_FALSE(holds(stops, R"("from")"));
}

TEST(Schema, OfARunIsDraftSeven) {
  EXPECT_TRUE(schema_of(config::run_form(), "rub")
                  .starts_with(R"({"$schema":"http://json-schema.org/draft-07/schema#",)"));
}

}  // namespace
}  // namespace rubsweep::apps
