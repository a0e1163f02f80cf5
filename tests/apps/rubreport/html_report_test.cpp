#include "rubreport/html_report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <regex>

#include "apps/rubreport/decoded.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "maps/sweep/one_side_study.hpp"
#include "rubreport/page.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::apps {

using namespace page;

namespace {

const sweep::Study study = sweep::one_side_study({50, 60, 70}, {0.2, 0.6});
const std::atomic<bool> go_on = false, at_once = true;

MapTable map_of_study() {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  batch::TableFile file(path, {"rubsweep 1.2.3", "digest-of-the-study", {}});
  file.write(report::map_comments() + report::map_header() + "\n");
  response::motion::Workspace workspace;
  for (std::size_t cell = 0; cell < sweep::cell_count(study.grid); ++cell)
    file.write(report::map_line(sweep::evaluate_cell(study, cell, workspace)) + "\n");
  file.commit();
  return read_map_table(path, study.grid);
}

std::string page_of(const MapTable& map, const std::filesystem::path& directory, int threads = 1,
                    std::size_t most_orbits = usual_orbits) {
  const PageOptions options{"1.2.3", "key: '<value> & more'\n", most_orbits, threads};
  return report_page(
             study, map, directory, options, [] {}, go_on)
      .value();
}

/// Content of the page's element with this `id`.
std::string element(const std::string& page, const std::string& id) {
  const std::string open = "<script type=\"text/plain\" id=\"" + id + "\">";
  const std::size_t begin = page.find(open);
  if (begin == std::string::npos) return "";
  return page.substr(begin + open.size(), page.find("</script>", begin) - begin - open.size());
}

TEST(HtmlReport, TheSameMapGivesTheSameBytesOnAnyNumberOfThreads) {
  const MapTable map = map_of_study();
  EXPECT_EQ(page_of(map, "/nowhere", 1), page_of(map, "/nowhere", 2));
}

TEST(HtmlReport, HoldsEachMotionOnceInTheOrderOfTheCells) {
  const std::string page = page_of(map_of_study(), "/nowhere");
  std::string block = decompressed(element(page, "orbits-0"));
  for (std::uint64_t cell = 0; cell < 6; ++cell) {
    ASSERT_GE(block.size(), 8u);
    Bytes head(block.substr(0, 8));
    EXPECT_EQ(head.integer(4), cell);
    block.erase(0, 8 + head.integer(4));
  }
  EXPECT_TRUE(block.empty());
  EXPECT_EQ(element(page, "orbits-1"), "");
}

TEST(HtmlReport, ALargeMapKeepsTheMotionsOfSomeCells) {
  const std::string page = page_of(map_of_study(), "/nowhere", 1, 2);
  EXPECT_NE(element(page, "index").find("\"recorded\":2,"), std::string::npos);
}

TEST(HtmlReport, IsCalledWhatTheConfigurationIs) {
  const PageOptions options{"1.2.3", "", usual_orbits, 1, {"Pump <3>", "N. N.", "first run"}};
  const std::string page = *report_page(
      study, map_of_study(), "/nowhere", options, [] {}, go_on);
  EXPECT_NE(page.find("<title>Pump &lt;3&gt;</title>"), std::string::npos);
  EXPECT_NE(page.find("<h1>Pump &lt;3&gt;</h1>\n<p id=\"byline\">N. N.: first run</p>"), std::string::npos);
  EXPECT_NE(page_of(map_of_study(), "/nowhere").find("<title>Rub map</title>"), std::string::npos);
}

TEST(HtmlReport, AxesAreShownAsTheyWereWritten) {
  EXPECT_NE(element(page_of(map_of_study(), "/nowhere"), "index").find("\"shown_axes\":[{},{}]"),
            std::string::npos);
  sweep::Study written = study;
  written.grid.written_speed = {"speed_rpm", "rpm", 60, {}, 0};
  written.grid.written_unbalance.spacing = {0.2, 0.6, 2, true};
  const PageOptions options{"1.2.3", "", usual_orbits, 1};
  const std::string index = element(*report_page(
                                        written, map_of_study(), "/nowhere", options, [] {}, go_on),
                                    "index");
  EXPECT_NE(index.find(R"("unit":"rpm","units_per_si":6E1)"), std::string::npos) << index;
  EXPECT_NE(index.find(R"({"logarithmic":true}])"), std::string::npos);
}

TEST(HtmlReport, NothingOutsideIsAskedFor) {
  std::string page = page_of(map_of_study(), "/nowhere");
  EXPECT_NE(page.find("default-src 'none'; script-src 'sha256-"), std::string::npos);
  // The page without the chart library, because a comment in it contains a web address.
  page.erase(page.find(library.text), library.text.size());
  for (const char* pattern :
       {R"(<script[^>]+src)", R"(<(link|iframe|object|embed|base)\b)", R"(@import|@font-face)",
        R"(url\(\s*['"]?(https?:|//))", R"((href|src)\s*=\s*['"]?(https?:|//))",
        R"(fetch\(|XMLHttpRequest|WebSocket|EventSource|sendBeacon|importScripts|import\()"})
    EXPECT_FALSE(std::regex_search(page, std::regex(pattern, std::regex::icase))) << pattern;
}

TEST(HtmlReport, ThePolicyNamesExactlyWhatThePageRuns) {
  const std::string page = page_of(map_of_study(), "/nowhere");
  EXPECT_NE(page.find("<style>" + std::string(style.text) + "</style>"), std::string::npos);
  EXPECT_NE(page.find("<script>" + std::string(script.text) + "</script>"), std::string::npos);
  EXPECT_NE(page.find("<script>" + std::string(library.text) + "</script>"), std::string::npos);
  std::string policy = page.substr(page.find("default-src"));
  policy.erase(policy.find('"'));
  for (const Asset* asset : {&library, &script, &style}) {
    const std::size_t hash = policy.find("sha256-") + 7;
    std::string digits;
    for (const char byte : from_base64(std::string_view(policy).substr(hash, policy.find('\'', hash) - hash)))
      digits += fmt::format("{:02x}", static_cast<unsigned char>(byte));
    EXPECT_EQ(digits, asset->sha256);
    policy.erase(0, hash);
    EXPECT_EQ(asset->text.find("</s"), std::string::npos) << "would end its element";
  }
}

TEST(HtmlReport, TextsOfOthersAreNoMarkup) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "boundaries.csv")
      << "family,speed_hz,unbalance\n</script><script>alert(1),50,0.2\n";
  const std::string page = page_of(map_of_study(), directory.path());
  EXPECT_NE(page.find("key: '&lt;value&gt; &amp; more'"), std::string::npos);
  EXPECT_NE(element(page, "index").find("\\u003c/script>\\u003cscript>alert(1)"), std::string::npos);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
}

TEST(HtmlReport, EndsWhereItIsToldTo) {
  EXPECT_FALSE(report_page(
      study, map_of_study(), "/nowhere", {}, [] {}, at_once));
}

TEST(HtmlReport, AMapOfAnotherSizeIsRefused) {
  MapTable map = map_of_study();
  map.rows = 5;
  EXPECT_THROW(page_of(map, "/nowhere"), IoError);
}

}  // namespace
}  // namespace rubsweep::apps
