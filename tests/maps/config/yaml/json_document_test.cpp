#include "rubsweep/maps/config/yaml/json_document.hpp"

#include "maps/config/support.hpp"

namespace rubsweep::config::yaml {
namespace {

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

TEST(JsonDocument, BecomesTheTreeOfTheFile) {
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

TEST(JsonDocument, WhatIsNoneSaysWhere) {
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
