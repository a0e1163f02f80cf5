#include "rubsweep/maps/config/yaml/alternatives.hpp"

#include <gtest/gtest.h>

#include <string>

#include "rubsweep/core/error.hpp"

namespace rubsweep::config::yaml {
namespace {

/// Remaining keys of {stribeck, kinetic, from, other} when `written` is about to be written over them.
std::string left_after(std::string_view written) {
  Node map{Node::Kind::map, SourcePosition{}};
  for (const char* key : {"stribeck", "kinetic", "from", "other"}) {
    map.keys.push_back({key, SourcePosition{}});
    map.items.push_back(Node{Node::Kind::null, SourcePosition{}});
  }
  drop_alternatives(map, written);
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
