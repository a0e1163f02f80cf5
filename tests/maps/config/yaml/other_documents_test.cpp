#include "rubsweep/maps/config/yaml/other_documents.hpp"

#include "maps/config/support.hpp"

namespace rubsweep::config::yaml {
namespace {

std::string toml_problem(const std::string& text) {
  Diagnostics diagnostics("kit.yaml", {});
  parse_toml(text, "rotor.file", diagnostics, diagnostics.add_file("rotor.toml"));
  try {
    diagnostics.throw_if_any();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(OtherDocumentsTomlDocument, BecomesTheTreeOfTheFile) {
  Diagnostics diagnostics("kit.yaml", {});
  const auto root = parse_toml(
      "version = \"2.0\"\n[b]\nx = 1e11\nn = [ 0, 1.5,]\nflag = true\n[a]\nk = -3\n[b.material]\nE = 2\n",
      "rotor.file", diagnostics, diagnostics.add_file("rotor.toml"));
  ASSERT_TRUE(root);
  ASSERT_EQ(root->keys.size(), 3U);
  EXPECT_EQ(root->keys[1].text, "b");
  EXPECT_EQ(root->keys[2].text, "a");
  EXPECT_TRUE(root->items[0].quoted);
  const Node& b = root->items[1];
  EXPECT_EQ(b.keys[0].text, "x");
  EXPECT_EQ(b.items[0].text, "100000000000");
  EXPECT_EQ(b.items[0].place, (SourcePosition{-1, 3, 5, 1}));
  EXPECT_EQ(b.items[1].items[1].text, "1.5");
  EXPECT_EQ(b.items[2].text, "true");
  EXPECT_EQ(b.keys[3].text, "material");
  EXPECT_EQ(b.items[3].items[0].text, "2");
  EXPECT_EQ(root->items[2].items[0].text, "-3");
  EXPECT_EQ(diagnostics.count(), 0U);
}

TEST(OtherDocumentsTomlDocument, WhatIsNoneSaysWhere) {
  EXPECT_TRUE(toml_problem("a = 1\nb = = 2\n").starts_with("rotor.toml:2:5: rotor.file: no TOML: "))
      << toml_problem("a = 1\nb = = 2\n");
  EXPECT_TRUE(toml_problem("a = 1\na = 2\n").starts_with("rotor.toml:2:")) << toml_problem("a = 1\na = 2\n");
  EXPECT_NE(
      toml_problem("a = \"" + std::string(max_document_bytes, 'x') + "\"\n").find("the file is too large"),
      std::string::npos);
  EXPECT_NE(toml_problem("a = " + std::string(40, '[') + std::string(40, ']') + "\n").find("too many values"),
            std::string::npos);
}

/// Each part of a dotted key is a table inside the table of the part before it.
TEST(OtherDocumentsTomlDocument, KeysOfManyPartsAreRefusedBeforeTheyAreTables) {
  std::string parts = "a";
  for (int i = 0; i < 40'000; ++i) parts += i % 2 == 0 ? ".a" : ". \"b\"";
  for (const std::string& text :
       {"[" + parts + "]\nb = 1\n", "[[" + parts + "]]\n", parts + " = 1\n", "c = {" + parts + " = 1}\n"})
    EXPECT_NE(toml_problem("# x.y\n" + text).find("rotor.toml:2:"), std::string::npos);
  std::string tables = "1";
  for (int i = 0; i < 200; ++i) tables = "{a.b.c.d.e.f.g.h = " + tables + "}";
  EXPECT_NE(toml_problem("a = " + tables + "\n").find("too many values"), std::string::npos);
}

TEST(OtherDocumentsTomlDocument, DotsInTextsAndNumbersMakeNothingDeep) {
  const std::string dots(100, '.');
  std::string numbers;
  for (int i = 0; i < 100; ++i) numbers += "1.5, ";
  EXPECT_EQ(
      toml_problem("a = \"" + dots + "\\\"" + dots + "\" # " + dots + "\nb = '" + dots + "'\nc = \"\"\"\n" +
                   dots + "\"" + dots + "\"\"\"\nd = [" + numbers + "]\ne = '''\n" + dots + "'''\n"),
      "no error");
}

std::string json_problem(const std::string& text) {
  Diagnostics diagnostics("kit.yaml", {});
  parse_json(text, "rotor.file", diagnostics, diagnostics.add_file("rotor.json"));
  try {
    diagnostics.throw_if_any();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(OtherDocumentsJsonDocument, BecomesTheTreeOfTheFile) {
  Diagnostics diagnostics("kit.yaml", {});
  const auto root = parse_json(
      "{\"b\": {\"x\": 1e11,\n  \"n\": [0, -1.5],\n  \"flag\": true, \"w\": null},\n \"a\": \"3\"}",
      "rotor.file", diagnostics, diagnostics.add_file("rotor.json"));
  ASSERT_TRUE(root);
  ASSERT_EQ(root->keys.size(), 2U);
  EXPECT_EQ(root->keys[0].text, "b");
  const Node& b = root->items[0];
  EXPECT_EQ(b.items[0].text, "100000000000");
  EXPECT_EQ(b.items[1].items[0].text, "0");
  EXPECT_EQ(b.items[1].items[1].text, "-1.5");
  EXPECT_EQ(b.items[1].items[1].place.line, 2);
  EXPECT_EQ(b.items[1].items[1].place.file, 1);
  EXPECT_EQ(b.keys[2].place.line, 3);
  EXPECT_EQ(b.items[2].text, "true");
  EXPECT_EQ(b.items[3].kind, Node::Kind::null);
  EXPECT_TRUE(root->items[1].quoted);
  EXPECT_EQ(root->items[1].place.line, 4);
}

TEST(OtherDocumentsJsonDocument, WhatIsNoneSaysWhere) {
  EXPECT_TRUE(json_problem("{\"a\": 1,\n \"b\": }").starts_with("rotor.json:2:7: rotor.file: no JSON: "))
      << json_problem("{\"a\": 1,\n \"b\": }");
  EXPECT_TRUE(json_problem("").starts_with("rotor.json:1:")) << json_problem("");
  EXPECT_TRUE(json_problem("{\"a\": NaN}").starts_with("rotor.json:1:")) << json_problem("{\"a\": NaN}");
  EXPECT_NE(json_problem("\"" + std::string(max_document_bytes, 'x') + "\"").find("the file is too large"),
            std::string::npos);
  EXPECT_NE(json_problem(std::string(4000, '[')).find("too many values"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config::yaml
