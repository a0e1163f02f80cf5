#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "html_report.hpp"
#include "no_report.hpp"
#include "report_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/report/describe_grid.hpp"
#include "shared/action.hpp"
#include "shared/command_line.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/program.hpp"
#include "shared/writable.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

po::options_description visible_options() {
  po::options_description options("Options");
  options.add_options()("output", po::value<std::string>()->value_name("FILE"),
                        "write there instead of DIR/report.html")(
      "orbits", po::value<long>()->value_name("N")->default_value(static_cast<long>(usual_orbits)),
      "of a larger map, only so many cells all over it keep their motions");
  add_threads(options, "threads; 0: one per processor");
  add_progress(options);
  add_last(options);
  return options;
}

std::string help() {
  return fmt::format(
      "rubreport DIR [options]\n"
      "Makes a page of a finished map to look at in a browser: the map, and the motion of each cell at a "
      "click.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubreport results/benchmark/one_side\n"
      "  rubreport results/benchmark/one_side --output /tmp/one_side.html\n"
      "  rubreport results/large --orbits 10000 --threads 2\n\n"
      "DIR is where rubsweep wrote map.csv and config.yaml; lines of DIR/boundaries.csv are drawn where "
      "there "
      "is such a file.\n"
      "The page is one file that needs no other and no network. rubsweep --report writes the same.\n\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration, or map and configuration in DIR are not of one run; "
      "3 "
      "input/output;\n"
      "70 out of memory or a fault of the program; 128+signal when interrupted.\n",
      text_of(visible_options()));
}

po::variables_map parse(int argc, char** argv) {
  po::options_description all = visible_options();
  all.add_options()("directory", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("directory", -1);
  return read_command_line(argc, argv, all, positional);
}

void refuse_input(const fs::path& output, const fs::path& directory) {
  for (const char* name : {"map.csv", "config.yaml", "boundaries.csv"}) {
    std::error_code none;
    if (fs::equivalent(output, directory / name, none))
      throw UsageError(
          fmt::format("--output {}: is read for the report, allowed: another file", output.string()));
  }
}

/// `caller`: name of the program in messages.
int perform(std::string_view caller, const po::variables_map& given) {
  if (answered("rubreport", action_of(given), help)) return done;
  const auto directories = given.count("directory") ? given["directory"].as<std::vector<std::string>>()
                                                    : std::vector<std::string>{};
  if (directories.size() != 1) throw UsageError("one directory with a map is needed: rubreport DIR");
  const long most_orbits = given["orbits"].as<long>();
  if (most_orbits < 1) throw UsageError("--orbits: allowed: a number >= 1");
  end_on_interrupts(no_report);
  const fs::path directory = directories.front();
  const fs::path file =
      given.count("output") ? fs::path(given["output"].as<std::string>()) : directory / "report.html";
  refuse_input(file, directory);
  require_writable(file, false);
  const config::RunConfig config = config::read_run_config(directory / "config.yaml", {});
  report::require_plane(config.study.grid, "a report");
  return write_report(directory, config.study, caller,
                      {.file = file,
                       .captions = config.captions,
                       .most_orbits = static_cast<std::size_t>(most_orbits),
                       .threads = threads_of(given),
                       .progress = progress_of(given),
                       .quiet = given.count("quiet") != 0});
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  // A program that calls this one for its report passes its own name, which then appears in messages.
  const std::string_view caller = program_invocation_short_name;
  return run_program(caller, [&] { return perform(caller, parse(argc, argv)); });
}
