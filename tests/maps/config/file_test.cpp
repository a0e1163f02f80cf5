#include "rubsweep/maps/config/file.hpp"

#include "maps/config/support.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config {
namespace {

std::string with_captions(const std::string& captions) { return captions + "\n" + test_file("minimal.yaml"); }

TEST(FileCaptions, AreReadPrintedAndNoPartOfTheDigest) {
  const std::string captions =
      "title: \"Pump 7: \\\"wet\\\" end\"\nauthor: R\xC3\xA9mi\nnote: |\n  first line\n\n  # third\n";
  const RunConfig config = read_run_config_text(with_captions(captions), "test.yaml", {}),
                  plain = read_run_config_text(with_captions(""), "test.yaml", {});
  EXPECT_EQ(config.captions,
            (batch::Captions{"Pump 7: \"wet\" end", "R\xC3\xA9mi", "first line\n\n# third\n"}));
  EXPECT_EQ(study_digest(config.study), study_digest(plain.study));
  const std::string printed = print_config(config);
  EXPECT_TRUE(printed.starts_with("title: ")) << printed;
  EXPECT_EQ(read_run_config_text(printed, "printed.yaml", {}).captions, config.captions);
  EXPECT_EQ(print_config(plain).find("title"), std::string::npos);
}

TEST(FileCaptions, HoldNothingThatATerminalWouldObey) {
  const auto problem = [](const std::string& caption) { return message_of(with_captions(caption)); };
  EXPECT_EQ(problem("title: \"a\\x1b[2Jb\""),
            "test.yaml:1:8: title: holds the character \\x1b, which cannot be shown, allowed: UTF-8 text of "
            "one line");
  EXPECT_EQ(problem("title: \"a\\nb\""),
            "test.yaml:1:8: title: holds the character \\x0a, which cannot be shown, allowed: UTF-8 text of "
            "one line");
  EXPECT_EQ(problem("note: \"a\\nb\\rc\""),
            "test.yaml:1:7: note: holds the character \\x0d, which cannot be shown, allowed: UTF-8 text and "
            "line ends");
  EXPECT_NE(problem("author: \"\\u202e\"").find("\\xe2\\x80\\xae"), std::string::npos) << "turns the writing";
  EXPECT_NE(problem("author: \"\\x9b2J\"").find("\\xc2\\x9b"), std::string::npos) << "ESC [ of Latin-1";
  EXPECT_EQ(problem("title: [a]"), "test.yaml:1:8: title: is a list, allowed: a text of 1 to 4096 bytes");
  EXPECT_EQ(problem("title: " + std::string(201, 'a')),
            "test.yaml:1:8: title: is too long, allowed: at most 200 bytes");
}

}  // namespace
}  // namespace rubsweep::config
