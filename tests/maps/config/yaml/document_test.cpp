#include "rubsweep/maps/config/yaml/document.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/error.hpp"

namespace rubsweep::config::yaml {
namespace {

Node parsed(const std::string& text) {
  Diagnostics diagnostics("f", {});
  auto node = parse_document(text, -1, "", diagnostics);
  diagnostics.throw_if_any();
  return *node;
}

std::string problem_of(const std::string& text) {
  try {
    parsed(text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no problem";
}

TEST(Document, KeepsKindsQuotesAndPlaces) {
  const Node root = parsed("a: 1\nb:\n  - 'x'\n  - {c: }\n");
  ASSERT_EQ(root.kind, Node::Kind::map);
  ASSERT_EQ(root.keys.size(), 2U);
  EXPECT_EQ(root.keys[1].text, "b");
  EXPECT_EQ(root.keys[1].place, (SourcePosition{-1, 2, 1}));
  EXPECT_EQ(root.items[0].text, "1");
  EXPECT_FALSE(root.items[0].quoted);
  EXPECT_EQ(root.items[0].place, (SourcePosition{-1, 1, 4}));
  const Node& list = root.items[1];
  ASSERT_EQ(list.kind, Node::Kind::list);
  EXPECT_TRUE(list.items[0].quoted);
  EXPECT_EQ(list.items[0].place, (SourcePosition{-1, 3, 5}));
  EXPECT_EQ(list.items[1].items[0].kind, Node::Kind::null);
}

TEST(Document, PlacesAMissingValueAtItsKey) {
  EXPECT_EQ(parsed("a:\n\n\nb: 1\n").items[0].place, (SourcePosition{-1, 1, 1}));
}

TEST(Document, KeepsRepeatedKeys) { EXPECT_EQ(parsed("a: 1\na: 2\n").items.size(), 2U); }

TEST(Document, IsNullWhenThereIsNothing) {
  for (const char* text : {"", "\n", "# only this", "---", "~"}) {
    EXPECT_EQ(parsed(text).kind, Node::Kind::null) << text;
  }
}

TEST(Document, TakesWhatEditorsAdd) {
  for (const char* text : {"\xEF\xBB\xBF"
                           "a: 1\n",
                           "a: 1\r\n", "%YAML 1.2\n---\na: 1\n...\n", "a: 1 # \xC3\xA9"}) {
    const Node root = parsed(text);
    ASSERT_EQ(root.keys.size(), 1U) << text;
    EXPECT_EQ(root.keys[0].text, "a");
    EXPECT_EQ(root.items[0].text, "1");
  }
}

TEST(Document, CopiesAliases) {
  Node root = parsed("a: &x {b: 1}\nc: *x\n");
  EXPECT_EQ(root.items[1].items[0].text, "1");
  root.items[1].items[0].text = "2";
  EXPECT_EQ(root.items[0].items[0].text, "1");
}

TEST(Document, PlacesAnOverrideAtItsIndex) {
  Diagnostics diagnostics("f", {"x=1", "y={a: 1}"});
  const auto node = parse_document("{a: 1}", 1, "y", diagnostics);
  ASSERT_TRUE(node);
  EXPECT_EQ(node->items[0].place, (SourcePosition{1, 1, 1}));
}

TEST(Document, BoundsDepthAlsoThroughAliases) {
  const std::string open(32, '[');
  const std::string close(32, ']');
  EXPECT_EQ(problem_of(open + close), "no problem");
  EXPECT_EQ(problem_of("[" + open + close + "]"), "f:1:33: nested too deep, allowed: at most 32 levels");
  EXPECT_EQ(problem_of("a: &x " + open.substr(1) + close.substr(1) + "\nb: *x\n"), "no problem");
  EXPECT_EQ(problem_of("a: &x " + open.substr(1) + close.substr(1) + "\nb: [*x]\n"),
            "f:2:5: nested too deep, allowed: at most 32 levels");
}

TEST(Document, BoundsTheNumberOfValues) {
  std::string bomb = "- &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    bomb += "- &a" + std::to_string(i) + " [" + alias;
    for (int k = 0; k < 9; ++k) bomb += ", " + alias;
    bomb += "]\n";
  }
  EXPECT_NE(problem_of(bomb).find("too many values, allowed: at most 100000"), std::string::npos);
}

TEST(Document, BoundsTheSize) {
  EXPECT_EQ(problem_of("#" + std::string(max_document_bytes - 1, ' ')), "no problem");
  EXPECT_EQ(problem_of("#" + std::string(max_document_bytes, ' ')),
            "f:1:1: too large, allowed: at most 16000000 bytes");
}

TEST(Document, BoundsTheTextThatAliasesCopy) {
  std::string text = "- &a '" + std::string(max_document_bytes / 4, 'x') + "'\n- *a\n- *a\n";
  EXPECT_EQ(problem_of(text), "no problem");
  EXPECT_EQ(problem_of(text + "- *a\n- *a\n"),
            "f:5:3: aliases copy too much text, allowed: at most 16000000 bytes");
}

TEST(Document, SurvivesRunsOfEveryIndicator) {
  for (const char indicator : {'[', '{', '-', '?', ':', '&', '*', '!', '|', '>', '\'', '"', '%', ',', ']'}) {
    for (const char* separator : {"", " ", "\n"}) {
      std::string text;
      while (text.size() < 20'000) text += indicator + std::string(separator);
      EXPECT_NO_FATAL_FAILURE(problem_of(text));
    }
  }
}

TEST(Document, EscapesWhatASyntaxMessageQuotes) {
  const std::string problem = problem_of("a: \"\\\xC3\xA9\"\n");
  EXPECT_NE(problem.find("not valid YAML"), std::string::npos) << problem;
  EXPECT_NE(problem.find("\\xc3"), std::string::npos) << problem;
}

}  // namespace
}  // namespace rubsweep::config::yaml
