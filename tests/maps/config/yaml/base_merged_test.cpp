#include <gtest/gtest.h>

#include <string>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"

namespace rubsweep::config::yaml {
namespace {

/// A node as one line, with maps in the order of their keys: {a: 1, b: [2, 3]}.
std::string written(const Node& node) {
  if (node.kind == Node::Kind::null) return "null";
  if (node.kind == Node::Kind::scalar) return node.text;
  std::string text;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    text += (i > 0 ? ", " : "") + (node.kind == Node::Kind::map ? node.keys[i].text + ": " : "") +
            written(node.items[i]);
  }
  return node.kind == Node::Kind::map ? "{" + text + "}" : "[" + text + "]";
}

struct Merge {
  Diagnostics diagnostics{"over", {}};
  int base_file = diagnostics.add_file("base");
  Node node;

  Merge(const std::string& base, const std::string& over)
      : node(merged(*parse_document(base, -1, "", diagnostics, base_file),
                    *parse_document(over, -1, "", diagnostics), "top", run_alternatives(), diagnostics)) {}

  std::string problems() const {
    try {
      diagnostics.throw_if_any();
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
};

std::string merge(const std::string& base, const std::string& over) {
  return written(Merge(base, over).node);
}

TEST(BaseMerged, OverridesAndAddsKeysAtEveryDepth) {
  EXPECT_EQ(merge("{a: 1, b: {c: 2, d: 3}}", "{b: {d: 4, e: 5}, f: 6}"),
            "{a: 1, b: {c: 2, d: 4, e: 5}, f: 6}");
}

TEST(BaseMerged, ReplacesListsAndWordsWhole) {
  EXPECT_EQ(merge("a: [1, 2, 3]", "a: [4]"), "{a: [4]}");
  EXPECT_EQ(merge("casing: {mass_kg: 1}", "casing: rigid"), "{casing: rigid}");
  EXPECT_EQ(merge("casing: rigid", "casing: {mass_kg: 1}"), "{casing: {mass_kg: 1}}");
}

TEST(BaseMerged, AKeyWithoutAValueTakesBackThatOfTheBase) {
  EXPECT_EQ(merge("{a: 1, kick: {force_n: 2}}", "kick:"), "{a: 1}");
  EXPECT_EQ(merge("a: 1", "kick:"), "{a: 1, kick: null}");
}

TEST(BaseMerged, AKeyTakesBackWhatTheBaseSaysByOtherMeans) {
  EXPECT_EQ(merge("{from: 1, to: 2, count: 3}", "values: [7]"), "{values: [7]}");
  EXPECT_EQ(merge("{from: 1, to: 2, count: 3}", "count: 5"), "{from: 1, to: 2, count: 5}");
  EXPECT_EQ(merge("{kick: 1}", "{kick: , start: 2}"), "{start: 2}");
  EXPECT_EQ(merge("{speed_hz: 1}", "{speed_rpm: 60, speed_hz: }"), "{speed_rpm: 60}");
  // Repeated keys of one file are kept, so that they are refused later.
  EXPECT_EQ(merge("stribeck: [1]", "{coefficient: 1, static: 2}"), "{coefficient: 1, static: 2}");
}

TEST(BaseMerged, AnotherKindSharesNothing) {
  EXPECT_EQ(merge("{kind: jeffcott, mass_kg: 1}", "{kind: rotor_kit, shaft: 2}"),
            "{kind: rotor_kit, shaft: 2}");
  EXPECT_EQ(merge("{kind: jeffcott, mass_kg: 1}", "{kind: jeffcott, a: 2}"),
            "{kind: jeffcott, mass_kg: 1, a: 2}");
}

TEST(BaseMerged, KeepsThePlaceOfWhatEachFileWrote) {
  const Node node = Merge("a: 1\nb:\n  c: 2\n", "\n\nb: {d: 3}\n").node;
  EXPECT_EQ(node.place, (SourcePosition{-1, 3, 1, 0}));
  EXPECT_EQ(node.items[0].place, (SourcePosition{-1, 1, 4, 1}));
  EXPECT_EQ(node.items[1].items[0].place, (SourcePosition{-1, 3, 6, 1}));
  EXPECT_EQ(node.items[1].items[1].place, (SourcePosition{-1, 3, 8, 0}));
  EXPECT_LT(node.items[0].place, node.place);
}

TEST(BaseMerged, RefusesRepeatedKeysOfEitherOnce) {
  const Merge merge("a: 1\na: 2\n", "b: 1\na: 3\nb: 4\n");
  EXPECT_EQ(merge.problems(),
            "base:2:1: top.a: given again, first at line 1, allowed: each key once\n"
            "over:3:1: top.b: given again, first at line 1, allowed: each key once");
  EXPECT_EQ(written(merge.node), "{a: 3, b: 1}");
}

}  // namespace
}  // namespace rubsweep::config::yaml
