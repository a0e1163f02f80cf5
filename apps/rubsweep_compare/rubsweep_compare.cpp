#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "compare_maps.hpp"
#include "compared_cells.hpp"
#include "comparison_figure.hpp"
#include "describe_comparison.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/map/earlier_results.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "shared/action.hpp"
#include "shared/child_process.hpp"
#include "shared/command_line.hpp"
#include "shared/exit_code.hpp"
#include "shared/program.hpp"
#include "shared/run_summary.hpp"
#include "shared/working_time.hpp"
#include "shared/writable.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

constexpr double default_tolerance = 1e-4;

po::options_description visible_options() {
  po::options_description options("Options");
  options.add_options()(
      "tolerance", po::value<double>()->value_name("R")->default_value(default_tolerance, "1e-4"),
      "largest relative difference of a number; lengths are relative to the cell's peak displacement")(
      "sensitive", po::value<std::string>()->value_name("FILE.csv"),
      "cells to leave out besides those whose robust column says no: columns speed_hz and whirl_ratio or "
      "eccentricity_m")(
      "figure", po::value<std::string>()->value_name("FILE"),
      "draw where the maps differ: FILE.png, FILE.svg, or FILE.gp for the gnuplot script alone")(
      "cells", po::value<std::string>()->value_name("FILE.csv"),
      "write every cell with its verdict: equal, sensitive, numbers_differ, classes_differ or only_in_one; "
      "`rubplot compare FILE.csv` draws it in the units of the first map");
  add_last(options);
  return options;
}

std::string help() {
  return fmt::format(
      "rubsweep-compare A.csv B.csv [options]\n"
      "Compares two maps cell by cell: class and order exactly, numbers of motions that repeat to a "
      "tolerance.\n\n"
      "{}\n"
      "Compared exactly: {} and, of motions that repeat, {}.\n"
      "Compared to the tolerance, of motions that repeat: {}.\n\n"
      "Examples:\n"
      "  rubsweep-compare results/golden/benchmark_small.csv /tmp/new/map.csv --figure "
      "/tmp/new/difference.png\n"
      "  rubsweep-compare gcc/map.csv clang/map.csv --tolerance 1e-9\n\n"
      "Exit codes: 0 the maps are equal on robust cells; 1 usage; 3 input/output; 5 they differ.\n",
      text_of(visible_options()), report::columns_compared(report::Comparison::label),
      report::columns_compared(report::Comparison::text),
      report::columns_compared(report::Comparison::number));
}

po::variables_map parse(int argc, char** argv) {
  po::options_description all = visible_options();
  all.add_options()("map", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("map", -1);
  return read_command_line(argc, argv, all, positional);
}

/// Draws the picture into a temporary file and renames it, so that it appears whole and gnuplot never sees
/// its name.
void draw(const std::string& script, const fs::path& picture) {
  batch::WholeFile file(picture);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> input(std::tmpfile(), &std::fclose);
  if (!input || std::fputs(script.c_str(), input.get()) < 0 || std::fflush(input.get()) != 0)
    throw IoError(fmt::format("a temporary file: {}", std::strerror(errno)));
  std::rewind(input.get());
  if (!run_child({"gnuplot", "-d"}, {.input = ::fileno(input.get()), .output = file.descriptor()}))
    throw IoError(fmt::format("{}: gnuplot could not draw it", picture.string()));
  file.commit();
}

void write_figure(const MapComparison& comparison, const std::string& heading, const fs::path& file) {
  if (file.extension() == ".gp") {
    fs::path picture = file;
    picture.replace_extension(".png");
    batch::write_whole_file(file, comparison_figure(comparison, heading, "pngcairo", picture));
  } else {
    const char* terminal = file.extension() == ".svg" ? "svg" : "pngcairo";
    draw(comparison_figure(comparison, heading, terminal, ""), file);
  }
}

int compare(const po::variables_map& given) {
  const auto maps =
      given.count("map") ? given["map"].as<std::vector<std::string>>() : std::vector<std::string>{};
  if (maps.size() != 2) throw UsageError("two maps are needed: rubsweep-compare A.csv B.csv");
  const double tolerance = given["tolerance"].as<double>();
  if (!std::isfinite(tolerance) || tolerance < 0) throw UsageError("--tolerance: allowed: a number >= 0");
  std::optional<fs::path> figure;
  if (given.count("figure")) {
    figure = given["figure"].as<std::string>();
    const std::string kind = figure->extension();
    if (kind != ".png" && kind != ".svg" && kind != ".gp") {
      throw UsageError("--figure: allowed: a name that ends with .png, .svg or .gp");
    }
    if (kind != ".gp" && !find_command("gnuplot"))
      throw IoError("--figure: there is no program called gnuplot to draw with (Debian: gnuplot-nox)");
    require_writable(*figure, false);
  }
  std::optional<fs::path> cells;
  if (given.count("cells")) {
    cells = given["cells"].as<std::string>();
    require_writable(*cells, false);
  }
  std::optional<fs::path> sensitive;
  if (given.count("sensitive")) sensitive = given["sensitive"].as<std::string>();
  for (const std::string& map : maps) map::require_whole_table("rubsweep-compare", map);
  std::optional<WorkingTime> working(std::in_place, "rubsweep-compare", "reads the maps",
                                     !given.count("quiet"));
  const auto comparison = compare_maps(maps[0], maps[1], tolerance, sensitive);
  working.reset();
  count_in_summary("cells", comparison.cells.size());
  count_in_summary("equal", comparison.count(CellVerdict::equal));
  if (!given.count("quiet")) print("{}", describe_comparison(comparison, tolerance));
  if (cells) write_compared_cells(*cells, comparison, maps[0], maps[1], tolerance);
  if (figure)
    write_figure(comparison,
                 fmt::format("{} -> {}; numbers to a tolerance of {:g}", maps[0], maps[1], tolerance),
                 *figure);
  return comparison.equal() ? done : maps_differ;
}

int perform(const po::variables_map& given) {
  if (answered("rubsweep-compare", action_of(given), help)) return done;
  return compare(given);
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubsweep-compare", [&] { return perform(parse(argc, argv)); });
}
