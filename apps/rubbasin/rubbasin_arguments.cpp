#include "rubbasin_arguments.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "shared/command_line.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

/// Largest number of initial states per direction, as on an axis of a sweep.
constexpr std::size_t most_starts_across = 10'000;

po::options_description visible_options() {
  po::options_description options("Options");
  options.add_options()(
      "cell", po::value<std::string>()->value_name("SPEED_HZ,UNBALANCE"),
      "the cell, the unbalance as the sweep has it (whirl ratio or eccentricity in metres)")(
      "plane", po::value<std::string>()->value_name("A,B"),
      "the two numbers of a start that the slice goes over: x, y, vx, vy of the rotor, casing0.x ... "
      "casing0.vy of the casing of stop 0, or keys of the configuration as --set names them; default: x,vx "
      "or y,vy, whichever is nearer to the normal of the first stop")(
      "grid", po::value<std::string>()->value_name("NxM")->default_value("65x65"),
      "starts across and up, evenly spaced, both ends included")(
      "from", po::value<std::string>()->value_name("A,B"),
      "smallest values, in m, m/s or the unit of the key; default: minus two clearances of the first stop, "
      "at velocities times the speed of rotation")("to", po::value<std::string>()->value_name("C,D"),
                                                   "largest values, likewise");
  add_figure(options, "also draw the slice as FILE.png, .svg or .pdf");
  options.add_options()("fresh", "forget what earlier runs finished, and start over");
  add_output(options, "write there instead of output.directory + _basin");
  add_threads(options, "threads; 0: one per processor");
  add_set(options);
  add_progress(options);
  add_last(options);
  return options;
}

template <class Number>
bool reads(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

std::optional<std::array<double, 2>> corner_of(const po::variables_map& given, const char* name) {
  if (given.count(name) == 0) return std::nullopt;
  const auto& text = given[name].as<std::string>();
  const std::size_t comma = text.find(',');
  std::array<double, 2> corner{};
  if (comma != std::string::npos) {
    const std::string_view whole = text;
    if (reads(whole.substr(0, comma), corner[0]) && reads(whole.substr(comma + 1), corner[1]) &&
        std::isfinite(corner[0]) && std::isfinite(corner[1]))
      return corner;
  }
  throw UsageError(fmt::format("--{} {}: allowed: two numbers parted by a comma", name, text));
}

std::array<std::size_t, 2> grid_of(const std::string& text) {
  const std::size_t cross = text.find('x');
  std::array<std::size_t, 2> starts{};
  if (cross != std::string::npos) {
    const std::string_view whole = text;
    const auto fits = [](std::size_t count) { return count >= 2 && count <= most_starts_across; };
    if (reads(whole.substr(0, cross), starts[0]) && reads(whole.substr(cross + 1), starts[1]) &&
        fits(starts[0]) && fits(starts[1]))
      return starts;
  }
  throw UsageError(fmt::format("--grid {}: allowed: NxM, both from 2 to {}", text, most_starts_across));
}

}  // namespace

RubbasinArguments parse_rubbasin_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_study_command_line(argc, argv, visible_options());
  RubbasinArguments arguments{study_arguments(given, "rubbasin")};
  if (arguments.action != Action::run) return arguments;
  if (given.count("cell") == 0) throw UsageError("the cell is needed: --cell SPEED_HZ,UNBALANCE");
  arguments.cell = read_cell(given["cell"].as<std::string>());
  if (given.count("plane") != 0) arguments.plane = read_plane(given["plane"].as<std::string>());
  arguments.from = corner_of(given, "from");
  arguments.to = corner_of(given, "to");
  if (arguments.from.has_value() != arguments.to.has_value())
    throw UsageError("--from and --to belong together");
  for (std::size_t i = 0; arguments.from && i < 2; ++i) {
    if (!((*arguments.from)[i] < (*arguments.to)[i]))
      throw UsageError("--from, --to: allowed: each number of --to larger than that of --from");
  }
  arguments.starts = grid_of(given["grid"].as<std::string>());
  arguments.fresh = given.count("fresh") != 0;
  arguments.figure = figure_of(given);
  arguments.threads = threads_of(given);
  arguments.progress = progress_of(given);
  return arguments;
}

std::string rubbasin_help() {
  return fmt::format(
      "rubbasin CONFIG.yaml --cell SPEED_HZ,UNBALANCE [--plane A,B] [options]\n"
      "Which motions coexist in one cell, and which starts lead to each: a slice through their basins.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubbasin configs/benchmark/one_side.yaml --cell 75,0.4\n"
      "  rubbasin configs/benchmark/one_side.yaml --cell 75,0.4 --plane y,vy --grid 129x129 --figure "
      "slice.png\n"
      "  rubbasin configs/minimal.yaml --cell 70,0.4 --plane x,casing0.x --from -1e-3,-1e-4 --to 1e-3,1e-4\n"
      "  rubbasin configs/minimal.yaml --cell 70,0.4 --plane kick.force_n,kick.angle_deg --from 0,0 --to "
      "400,360\n\n"
      "Runs the cell from every start until its motion is known. A start is the state at the instant of "
      "smallest quiet\n"
      "gap, without a kick: the two numbers of the plane from the grid, the others those of the quiet "
      "whirl. A plane of\n"
      "keys varies those instead. Motions are one attractor when class and order are equal and no length of "
      "the orbit\n"
      "differs by more than a thousandth; motions that never repeat are one attractor per class.\n\n"
      "Writes into DIR:\n"
      "  slice.csv       a row for each start, the first number of the plane fastest: both numbers with "
      "their units,\n"
      "                  attractor (empty: failed), label, status\n"
      "  attractors.csv  a row for each attractor, the most frequent first: share and standard error, what "
      "tells it\n"
      "                  apart, and the first start that leads to it\n"
      "  map.csv         the same starts with all columns of a map; rubsweep DIR/config.yaml computes it, "
      "too\n"
      "  config.yaml     the complete configuration\n"
      "However a run ends before all starts are done, DIR/map.journal keeps the finished ones and the same "
      "command\n"
      "computes the others.\n\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration, or DIR holds starts of another slice; 3 "
      "input/output;\n"
      "4 done, but some runs failed; 6 another process is at work in DIR; 70 out of memory or a fault of "
      "the program;\n"
      "128+signal when interrupted.\n",
      text_of(visible_options()));
}

}  // namespace rubsweep::apps
