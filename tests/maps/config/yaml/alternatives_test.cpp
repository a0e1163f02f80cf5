#include "rubsweep/maps/config/yaml/alternatives.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::yaml {
namespace {

using Names = std::vector<std::string>;

/// A map has the keys `keys`. Returns the keys that remain when `written` is about to be written over the
/// map.
std::string left_after(std::string_view written, const Names& keys = {"stribeck", "kinetic", "from", "other"},
                       const Alternatives& alternatives = run_alternatives()) {
  Node map{Node::Kind::map, SourcePosition{}};
  for (const std::string& key : keys) {
    map.keys.push_back({key, SourcePosition{}});
    map.items.push_back(Node{Node::Kind::null, SourcePosition{}});
  }
  alternatives.drop(map, written);
  EXPECT_EQ(map.keys.size(), map.items.size());
  std::string names;
  for (const Node::Key& key : map.keys) names += key.text + " ";
  return names;
}

TEST(Alternatives, AKeyTakesBackWhatSaysTheSameByOtherMeans) {
  EXPECT_EQ(left_after("coefficient"), "from other ");
  EXPECT_EQ(left_after("values"), "stribeck kinetic other ");
}

TEST(Alternatives, AKeyKeepsItsOwnKindAndWhatItHasNothingToDoWith) {
  EXPECT_EQ(left_after("static"), "kinetic from other ");
  EXPECT_EQ(left_after("count"), "stribeck kinetic from other ");
  EXPECT_EQ(left_after("anything"), "stribeck kinetic from other ");
}

TEST(Alternatives, WhatStoodBesideADroppedKeyGoesWhereTheWrittenOneNeedsItNot) {
  const Names curve{"static", "kinetic", "peak_speed_m_per_s", "settle_speed_m_per_s", "viscous_s_per_m"};
  EXPECT_EQ(left_after("coefficient", curve), "");
  EXPECT_EQ(left_after("static", {"coefficient"}), "coefficient ");
  EXPECT_EQ(left_after("key", {"keys", "factors", "values"}), "values ");
  EXPECT_EQ(left_after("step", {"from", "to", "count", "scale"}), "from to ");
  EXPECT_EQ(left_after("count", {"from", "to", "step"}), "from to ");
  EXPECT_EQ(left_after("rated_speed_rpm", {"balance_grade_mm_per_s", "rated_speed_hz"}),
            "balance_grade_mm_per_s ");
  EXPECT_EQ(left_after("law", {"stiffness_n_per_m", "restitution", "friction"}), "friction ");
  EXPECT_EQ(left_after("law", {"hertz", "restitution"}), "hertz ");
  EXPECT_EQ(left_after("stiffness_n_per_m", {"law", "clearance_m"}), "clearance_m ");
}

TEST(Alternatives, WhatAnOverrideGaveStandsBesideTheNextOne) {
  const auto study =
      read_run_config_text(
          "stops: [{kind: one_side, angle_deg: 90, clearance_m: 0.001, stiffness_n_per_m: 1.0e6,\n"
          "restitution: 0.5, contact_radius_m: 0.01}]\n"
          "rotor: {kind: jeffcott, mass_kg: 1, natural_frequency_hz: 40, damping_ratio: 0.02}\n"
          "sweep: {speed_hz: {values: [50]}, whirl_ratio: {values: [0.5]},\n"
          "  x: {key: stops.0.stiffness_n_per_m, values: [1.0e6, 2.0e6]}}\n"
          "output: {directory: out}\n",
          "f.yaml", {"sweep.x.factors=[1, 1e-6]", "sweep.x.keys=[stops.0.stiffness_n_per_m, rotor.mass_kg]"})
          .study;
  ASSERT_EQ(study.grid.axes.size(), 1u);
  EXPECT_EQ(study.grid.axes[0].factors, (std::vector<double>{1, 1e-6}));
}

TEST(Alternatives, TheKeysOfAMapTellItsKind) {
  // A degree of freedom has both a node and a place, an unbalance has one of the two.
  EXPECT_EQ(left_after("position_m", {"node", "direction"}), "node direction ");
  EXPECT_EQ(left_after("position_m", {"node", "mass_kg", "eccentricity_ratio"}),
            "mass_kg eccentricity_ratio ");
}

TEST(Alternatives, FollowTheFormOfAConfiguration) {
  using namespace keys;
  const Form form = map_of({must(
      "inner",
      list_of(map_of({must("a", text(), ""), must("b", text(), ""), may("c", text(), "")},
                     {choice_of({{must("a", text(), "")}, {must("b", text(), ""), may("c", text(), "")}})}),
              1, 2),
      "")});
  EXPECT_EQ(left_after("a", {"b", "c", "d"}, Alternatives(form)), "d ");
  EXPECT_EQ(left_after("c", {"a"}, Alternatives(form)), "");
  EXPECT_EQ(left_after("c", {"b"}, Alternatives(form)), "b ");
  EXPECT_EQ(left_after("values", {"from"}, Alternatives(form)), "from ");
}

TEST(AlternativesRepeatedKeys, EachLaterOneIsRefusedAndRemoved) {
  Diagnostics diagnostics("f", {});
  Node map = *parse_document("a: 1\nb: 2\na: 3\na: 4\n", -1, "", diagnostics);
  refuse_repeated_keys(map, "top", diagnostics);
  try {
    diagnostics.throw_if_any();
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "f:3:1: top.a: given again, first at line 1, allowed: each key once\n"
                 "f:4:1: top.a: given again, first at line 1, allowed: each key once");
  }
  drop_repeated_keys(map);
  ASSERT_EQ(map.keys.size(), 2U);
  EXPECT_EQ(map.keys[0].text, "a");
  EXPECT_EQ(map.items[0].text, "1");
  EXPECT_EQ(map.keys[1].text, "b");
}

TEST(AlternativesRepeatedKeys, DifferentKeysAreNoProblem) {
  Diagnostics diagnostics("f", {});
  refuse_repeated_keys(*parse_document("a: 1\nb: 1\n", -1, "", diagnostics), "", diagnostics);
  EXPECT_EQ(diagnostics.count(), 0U);
}

}  // namespace
}  // namespace rubsweep::config::yaml
