#include "rubbranch_arguments.hpp"

#include <fmt/format.h>

#include <cmath>

#include "shared/command_line.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

constexpr int usual_points = 2000;

po::options_description visible_options() {
  po::options_description options("Options");
  options.add_options()("cell", po::value<std::string>()->value_name("SPEED_HZ,UNBALANCE"),
                        "the cell whose settled orbit is followed, the unbalance as the sweep has it (whirl "
                        "ratio or eccentricity in metres)")(
      "along", po::value<std::string>()->value_name("KEY")->default_value("speed_hz"),
      "the parameter that changes: speed_hz, whirl_ratio, eccentricity_m, or any number of the configuration "
      "by its key, as --set names it")(
      "from", po::value<double>()->value_name("A"),
      "smallest value of the parameter; default: that of the sweep, for a key half of what it is")(
      "to", po::value<double>()->value_name("B"),
      "largest value; default: that of the sweep, for a key twice what it is")(
      "curve", po::value<std::string>()->value_name("KEY"),
      "a second parameter, named as --along: from every event of the branch a curve in the plane of both")(
      "curve-from", po::value<double>()->value_name("A"), "its smallest value; default: as --from")(
      "curve-to", po::value<double>()->value_name("B"), "its largest value; default: as --to")(
      "switch", "at each period doubling follow the orbit of twice the period as well")(
      "points", po::value<int>()->value_name("N")->default_value(usual_points),
      "orbits to find at most on each side of the cell")(
      "map", po::value<std::string>()->value_name("DIR"),
      "instead of a cell: every family of orbits of the finished map in DIR, to its boundaries")(
      "fresh", "with --map: forget what an interrupted call found, and start over");
  add_threads(options, "threads for --map; 0: one per processor");
  add_output(options, "write there instead of output.directory + _branch");
  add_set(options);
  add_last(options);
  return options;
}

/// Reads the arguments of --map, which replaces the configuration file.
RubbranchArguments map_arguments(const po::variables_map& given) {
  RubbranchArguments arguments;
  arguments.action = action_of(given);
  arguments.quiet = given.count("quiet") != 0;
  if (given.count("output") != 0) arguments.output = given["output"].as<std::string>();
  return arguments;
}

std::optional<double> finite(const po::variables_map& given, const char* name) {
  if (given.count(name) == 0) return std::nullopt;
  const double value = given[name].as<double>();
  if (!std::isfinite(value)) throw UsageError(fmt::format("--{}: allowed: a finite number", name));
  return value;
}

}  // namespace

RubbranchArguments parse_rubbranch_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_study_command_line(argc, argv, visible_options());
  RubbranchArguments arguments = given.count("map") != 0
                                     ? map_arguments(given)
                                     : RubbranchArguments{study_arguments(given, "rubbranch")};
  if (arguments.action != Action::run) return arguments;
  arguments.threads = threads_of(given);
  if (given.count("map") != 0) {
    arguments.map = given["map"].as<std::string>();
    arguments.fresh = given.count("fresh") != 0;
    for (const char* name :
         {"config", "cell", "from", "to", "curve", "curve-from", "curve-to", "switch", "set"}) {
      if (given.count(name) != 0) throw UsageError("--map takes the configuration of the map, and no cell");
    }
    for (const char* name : {"along", "points"}) {
      if (!given[name].defaulted())
        throw UsageError(fmt::format("--{} belongs to a cell, not to --map", name));
    }
    return arguments;
  }
  if (given.count("fresh") != 0) throw UsageError("--fresh goes with --map");
  if (given.count("cell") == 0) throw UsageError("a cell to start from is needed: --cell SPEED_HZ,UNBALANCE");
  arguments.cell_values = read_cell_values(given["cell"].as<std::string>());
  arguments.along = given["along"].as<std::string>();
  arguments.from = finite(given, "from");
  arguments.to = finite(given, "to");
  if (arguments.from && arguments.to && !(*arguments.from < *arguments.to))
    throw UsageError("--from and --to: allowed: a number and a larger one");
  if (given.count("curve") != 0) arguments.curve = given["curve"].as<std::string>();
  arguments.curve_from = finite(given, "curve-from");
  arguments.curve_to = finite(given, "curve-to");
  if ((arguments.curve_from || arguments.curve_to) && arguments.curve.empty())
    throw UsageError("--curve-from and --curve-to belong to --curve KEY");
  if (arguments.curve_from && arguments.curve_to && !(*arguments.curve_from < *arguments.curve_to))
    throw UsageError("--curve-from and --curve-to: allowed: a number and a larger one");
  arguments.switch_at_doublings = given.count("switch") != 0;
  arguments.most_points = given["points"].as<int>();
  if (arguments.most_points < 2) throw UsageError("--points: allowed: a number >= 2");
  return arguments;
}

std::string rubbranch_help() {
  return fmt::format(
      "rubbranch CONFIG.yaml --cell SPEED_HZ,UNBALANCE [--along KEY] [options]\n"
      "rubbranch --map DIR [options]\n"
      "Where an orbit ends: the periodic motion of one cell (or the oval in a centred annulus), followed "
      "both "
      "ways along a\nparameter, stable or not, through folds and grazes, with every bifurcation on it.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubbranch configs/benchmark/one_side.yaml --cell 75,0.4\n"
      "  rubbranch configs/benchmark/one_side.yaml --cell 75,0.4 --along whirl_ratio --switch\n"
      "  rubbranch configs/minimal.yaml --cell 70,0.4 --along stops.0.casing.mass_kg --from 0.02 --to 0.2\n"
      "  rubbranch configs/benchmark/one_side.yaml --cell 75,0.4 --curve whirl_ratio\n"
      "  rubbranch --map results/benchmark/one_side\n\n"
      "Writes into DIR:\n"
      "  branch.csv   a row for every orbit by ascending arclength: parameter, order, stability, "
      "multipliers,\n"
      "               amplitude, peaks, hits and share of contact over its period\n"
      "  events.csv   fold, period_doubling, neimark_sacker, branch_point, period_halving and graze, each "
      "located as a root\n"
      "  config.yaml  the complete configuration\n"
      "With --curve also:\n"
      "  curves.csv   a row for every point of a curve: both parameters, kind, the event it starts from, "
      "arclength,\n"
      "               multipliers, amplitude, hits\n"
      "  meetings.csv where a curve meets another one: cusp, fold_flip, resonance_1_2, graze_fold and "
      "others\n"
      "With --map beside map.csv, or into DIR:\n"
      "  boundaries.csv  lines around the domain of every family: family, kind, speed_hz and the map's "
      "unbalance\n"
      "  families.csv    order, hits, cells and area of existence, share that the kick reaches\n"
      "  edges.csv       why neighbouring cells differ: the orbit ceases (and how), the basin ends, or "
      "unresolved\n"
      "  contradictions.csv  labels of the map that the domains of the families do not explain, and what was "
      "found of each\n"
      "However a call with --map ends before these are written, what it found is kept in families.journal "
      "and "
      "the same\ncommand goes on from there.\n"
      "A branch ends where the parameter leaves its range (left_range), where it closes, joins that of half "
      "its period\n"
      "(period_halving), comes off the walls for good (off_the_walls), where there is no such machine "
      "(infeasible), where\n"
      "no orbit is found however near the last one (step_too_small, singular, failed), or at --points.\n\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration; 3 input/output; 4 the cell settles on no periodic "
      "orbit in contact,\nor Newton's iteration does not find it: nothing is written; with --map some proven "
      "orbit was not found "
      "again; 128+signal when interrupted.\n",
      text_of(visible_options()));
}

}  // namespace rubsweep::apps
