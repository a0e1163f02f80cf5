#include "rubsweep/maps/config/yaml/alternatives.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rubsweep::config::yaml {
namespace {

/// Keys left of {stribeck, kinetic, from, other} after `written` is about to be written over them.
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

}  // namespace
}  // namespace rubsweep::config::yaml
