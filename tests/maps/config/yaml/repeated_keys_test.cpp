#include "rubsweep/maps/config/yaml/repeated_keys.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/error.hpp"

namespace rubsweep::config::yaml {
namespace {

TEST(RepeatedKeys, EachLaterOneIsRefusedAndRemoved) {
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

TEST(RepeatedKeys, DifferentKeysAreNoProblem) {
  Diagnostics diagnostics("f", {});
  refuse_repeated_keys(*parse_document("a: 1\nb: 1\n", -1, "", diagnostics), "", diagnostics);
  EXPECT_EQ(diagnostics.count(), 0U);
}

}  // namespace
}  // namespace rubsweep::config::yaml
