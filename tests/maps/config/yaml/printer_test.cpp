#include "rubsweep/maps/config/yaml/printer.hpp"

#include <gtest/gtest.h>

#include <array>

#include "rubsweep/core/error.hpp"

namespace rubsweep::config::yaml {
namespace {

TEST(Printer, IndentsMapsAndListsOfMaps) {
  Printer printer;
  printer.open("a");
  printer.integer("b", -3);
  printer.open("list");
  for (const char* word : {"x", "y"}) {
    printer.open_item();
    printer.word("word", word);
    printer.open("inner");
    printer.number("c", 0.1);
    printer.close();
    printer.close();
  }
  printer.close();
  printer.close();
  printer.numbers("d", std::array{1.0, 2e-8, -0.0});
  EXPECT_EQ(printer.yaml(),
            "a:\n"
            "  b: -3\n"
            "  list:\n"
            "    - word: x\n"
            "      inner:\n"
            "        c: 0.1\n"
            "    - word: y\n"
            "      inner:\n"
            "        c: 0.1\n"
            "d: [1, 2e-08, -0]\n");
}

TEST(Printer, WritesLinesAsABlock) {
  Printer printer;
  printer.open("a");
  printer.block("text", "%%one 1\n2 3\n");
  printer.close();
  printer.block("b", "last\n");
  EXPECT_EQ(printer.yaml(), "a:\n  text: |\n    %%one 1\n    2 3\nb: |\n  last\n");
}

TEST(Printer, QuotesTextOnlyWhereNeeded) {
  const auto printed = [](std::string_view text) {
    Printer printer;
    printer.text("t", text);
    return printer.yaml();
  };
  EXPECT_EQ(printed("results/one_side-2.d"), "t: results/one_side-2.d\n");
  EXPECT_EQ(printed("null"), "t: \"null\"\n");
  EXPECT_EQ(printed(""), "t: \"\"\n");
  EXPECT_EQ(printed("..."), "t: \"...\"\n");
  EXPECT_EQ(printed("a \"b\" \\ \n"), "t: \"a \\\"b\\\" \\\\ \\n\"\n");
  EXPECT_THROW(printed("\xC3("), ConfigError);
}

TEST(Printer, LeavesOutOptionalNumbersWithoutValue) {
  Printer printer;
  printer.field("absent", std::optional<double>(), model::any_finite);
  printer.field("present", std::optional<double>(2), model::any_finite);
  EXPECT_EQ(printer.yaml(), "present: 2\n");
}

}  // namespace
}  // namespace rubsweep::config::yaml
