#include "rubsweep/maps/config/yaml/section.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/error.hpp"

namespace rubsweep::config::yaml {
namespace {

std::string problems(const Diagnostics& diagnostics) {
  try {
    diagnostics.throw_if_any();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

struct Fixture {
  Diagnostics diagnostics{"f", {}};
  Node node;
  explicit Fixture(const std::string& text) : node(*parse_document(text, -1, "", diagnostics)) {}
  Value value() { return {node, "top", diagnostics}; }
};

TEST(Section, GivesValuesAndKeepsDefaults) {
  Fixture file("{a: 1, n: 3}");
  Section section(file.value());
  double a = model::required;
  double b = 2;
  int n = 0;
  section.field("a", a, model::positive);
  section.field("b", b, model::positive);
  section.field("n", n, IntegerRange{0, 10});
  section.refuse_unknown_keys();
  EXPECT_EQ(a, 1);
  EXPECT_EQ(b, 2);
  EXPECT_EQ(n, 3);
  EXPECT_EQ(problems(file.diagnostics), "");
}

TEST(Section, MissesOnlyWhatHasNoDefault) {
  Fixture file("{}");
  Section section(file.value());
  double a = model::required;
  double b = 2;
  std::optional<double> c;
  section.field("a", a, model::positive);
  section.field("b", b, model::positive);
  section.field("c", c, model::positive);
  EXPECT_EQ(problems(file.diagnostics), "f:1:1: top.a: missing, allowed: a number > 0");
}

TEST(Section, IsSoundUntilSomethingOfItIsRefused) {
  Fixture file("{a: 1, b: -1}");
  Section section(file.value());
  double a = model::required, b = model::required;
  section.field("a", a, model::positive);
  EXPECT_TRUE(section.is_sound());
  section.field("b", b, model::positive);
  EXPECT_FALSE(section.is_sound());
  EXPECT_TRUE(Section(Value{file.node, "later", file.diagnostics}).is_sound());
}

TEST(Section, ThatIsNoMapIsNotSound) {
  for (const char* text : {"1", "[1]", "{a: 1, a: 2}"}) {
    Fixture file(text);
    EXPECT_FALSE(Section(file.value()).is_sound()) << text;
  }
}

TEST(Section, ThatIsNoMapHasOneProblem) {
  Fixture file("[1]");
  Section section(file.value());
  double a = model::required;
  section.field("a", a, model::positive);
  section.require("b", "anything");
  section.require_exactly_one({"c", "d"});
  section.refuse_unknown_keys();
  EXPECT_EQ(problems(file.diagnostics), "f:1:1: top: is a list, allowed: a map");
}

TEST(Section, RefusesAnUnknownKeyOnceAndNeverAKnownOne) {
  Fixture file("{a: 1, zz: 1, zz: 2}");
  Section section(file.value());
  section.find("a");
  section.find("b");
  section.refuse_unknown_keys();
  EXPECT_EQ(problems(file.diagnostics),
            "f:1:8: top.zz: unknown key, allowed: a, b\n"
            "f:1:15: top.zz: given again, first at line 1, allowed: each key once");
}

TEST(Section, RefusesUnknownKeysAtItsEndUnlessAllKeysAreAllowed) {
  Fixture file("{a: 1, zz: 1}");
  for (const bool allowed : {true, false}) {
    {
      Section section(file.value());
      section.find("a");
      if (allowed) section.allow_unknown_keys();
      EXPECT_TRUE(section.is_sound());
    }
    EXPECT_EQ(file.diagnostics.count(), allowed ? 0U : 1U);
  }
  EXPECT_EQ(problems(file.diagnostics), "f:1:8: top.zz: unknown key, allowed: a");
}

TEST(Section, NamesTheLastOfTooManyAlternatives) {
  Fixture file("{c: 1, a: 1, b: 1}");
  Section section(file.value());
  section.require_exactly_one({"a", "b", "c"});
  EXPECT_EQ(problems(file.diagnostics),
            "f:1:17: top.b: given beside c (f:1:5), a (f:1:11), allowed: exactly one of a, b, c");
}

TEST(Section, TakesIntegersHoweverTheyAreWritten) {
  const struct {
    const char* text;
    const char* problem;
  } cases[] = {
      {"{n: 600}", ""},
      {"{n: 6e2}", ""},
      {"{n: 600.0}", ""},
      {"{n: 600.5}", "f:1:5: top.n: 600.5 is not an integer, allowed: an even integer from 2 to 1000"},
      {"{n: 601}", "f:1:5: top.n: 601 is odd, allowed: an even integer from 2 to 1000"},
      {"{n: 1e30}", "f:1:5: top.n: 1e30 is out of range, allowed: an even integer from 2 to 1000"},
      {"{n: 0}", "f:1:5: top.n: 0 is out of range, allowed: an even integer from 2 to 1000"},
      {"{n: '600'}",
       "f:1:5: top.n: '600' is text in quotes, not an integer, allowed: an even integer from 2 to 1000"}};
  for (const auto& [text, problem] : cases) {
    Fixture file(text);
    Section section(file.value());
    long n = 0;
    section.field("n", n, IntegerRange{2, 1000, true});
    EXPECT_EQ(problems(file.diagnostics), problem) << text;
    EXPECT_EQ(n, std::string(problem).empty() ? 600 : 0) << text;
  }
}

TEST(Section, PlacesAJointProblemAtTheLastKeyGiven) {
  Fixture file("{b: 1,\n a: 2}");
  const Section section(file.value());
  section.refuse_together("b", {"a", "b", "c"}, "too small for a", "more");
  EXPECT_EQ(problems(file.diagnostics), "f:2:5: top.b: too small for a, allowed: more");
}

}  // namespace
}  // namespace rubsweep::config::yaml
