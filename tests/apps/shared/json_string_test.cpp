#include "shared/json_string.hpp"

#include <gtest/gtest.h>

namespace rubsweep::apps {
namespace {

TEST(JsonString, EscapesWhatJsonDoesNotTake) {
  EXPECT_EQ(json_string(R"(a "b" \c /)"), R"("a \"b\" \\c /")");
  EXPECT_EQ(json_string("\t\n\r\b\f"), R"("\t\n\r\b\f")");
  EXPECT_EQ(json_string(std::string_view("\x01\0\x1f\x7f", 4)), "\"\\u0001\\u0000\\u001f\x7f\"");
}

TEST(JsonString, LeavesUtf8AsItIs) { EXPECT_EQ(json_string("µm"), "\"µm\""); }

TEST(JsonString, BytesThatAreNoUtf8AreReplaced) { EXPECT_EQ(json_string("a\xff"), "\"a\uFFFD\""); }

TEST(JsonString, ListsHoldEveryTextEmptyOnesToo) {
  EXPECT_EQ(json_list({}), "[]");
  EXPECT_EQ(json_list({"a", ""}), R"(["a",""])");
}

}  // namespace
}  // namespace rubsweep::apps
