#include "rubsweep/maps/config/yaml/diagnostics.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/error.hpp"

namespace rubsweep::config::yaml {
namespace {

TEST(Diagnostics, ThrowsNothingWithoutAProblem) { EXPECT_NO_THROW(Diagnostics("a.yaml", {}).throw_if_any()); }

TEST(Diagnostics, ListsTheFileByPlaceThenTheOverridesInOrder) {
  Diagnostics diagnostics("a.yaml", {"x=1", "y=2"});
  diagnostics.add({1, 1, 1}, "y", "fifth", "");
  diagnostics.add({0, 1, 1}, "x", "fourth", "");
  diagnostics.add({-1, 10, 1}, "c", "third", "some c");
  diagnostics.add({-1, 9, 12}, "b", "second", "");
  diagnostics.add({-1, 9, 2}, "", "first", "");
  diagnostics.add({0, 1, 1}, "x", "fourth, added later", "");
  EXPECT_EQ(diagnostics.count(), 6U);
  try {
    diagnostics.throw_if_any();
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "a.yaml:9:2: first\n"
                 "a.yaml:9:12: b: second\n"
                 "a.yaml:10:1: c: third, allowed: some c\n"
                 "--set x=1: x: fourth\n"
                 "--set x=1: x: fourth, added later\n"
                 "--set y=2: y: fifth");
  }
}

}  // namespace
}  // namespace rubsweep::config::yaml
