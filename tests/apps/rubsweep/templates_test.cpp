#include "rubsweep/templates.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::apps::templates {
namespace {

TEST(Templates, AreReadWithoutAProblemOrAQuestion) {
  ASSERT_EQ(template_names().size(), 5u);
  for (const std::string_view name : template_names()) {
    const auto text = template_text(name);
    ASSERT_TRUE(text) << name;
    // One of the templates reads a file of ROSS beside it.
    const auto file = std::filesystem::path(TEMPLATE_FOLDER) / "my.yaml";
    const config::RunConfig config = config::read_run_config_text(*text, file.string(), {});
    EXPECT_TRUE(config.questions.empty()) << name << ": " << config.questions.front();
    EXPECT_EQ(config.output_directory, "results/" + std::string(name));
    EXPECT_FALSE(config.captions.title.empty()) << name;
  }
}

TEST(Templates, NameTheSchemaBesideThem) {
  for (const std::string_view name : template_names()) {
    EXPECT_TRUE(template_text(name)->starts_with("# yaml-language-server: $schema=rubsweep.schema.json\n"));
    EXPECT_EQ(template_text(name)->find("../"), std::string::npos) << name;
  }
}

TEST(Templates, AreOfKnownKinds) {
  EXPECT_FALSE(template_text("one_sid"));
  EXPECT_FALSE(template_text(""));
}

}  // namespace
}  // namespace rubsweep::apps::templates
