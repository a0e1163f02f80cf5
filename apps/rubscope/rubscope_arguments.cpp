#include "rubscope_arguments.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "rubsweep/measurement/scope/verdict.hpp"
#include "shared/command_line.hpp"
#include "shared/program.hpp"
#include "shared/shown_lengths.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

po::options_description visible_options() {
  po::options_description options("Options");
  add_instrument(options);
  options.add_options()("columns",
                        "list what was understood of RECORDING, without a description: columns with unit, "
                        "range and first values, "
                        "and what was left out")(
      "orders", po::value<std::string>()->value_name("P,P,..."),
      "orders of the Bode plot, multiples of 1/8; 1,2 unless given")(
      "least-line", po::value<double>()->value_name("PERCENT"),
      "smallest line that counts for a period, in per cent of the largest one; 0.5 unless given")(
      "most-modulation", po::value<double>()->value_name("PERCENT"),
      "what lines may slowly vary by, in per cent of the motion, and still belong to their period; one line "
      "by twice as much of itself; 10 unless given")(
      "compare", po::value<std::string>()->value_name("CONFIG.yaml"),
      "lay the recording over a simulated motion, that of --cell, by the first sensor of a rotor kit or by "
      "the rotor")("cell", po::value<std::string>()->value_name("SPEED_HZ,UNBALANCE"),
                   "cell of CONFIG.yaml to compare with");
  add_set(options);
  add_output(options, "write there instead of into RECORDING without its ending and with _scope");
  add_figure(options, "draw orbit, section, lines and speed");
  add_shown_lengths(options);
  add_last(options);
  return options;
}

std::vector<double> orders_of(std::string_view text) {
  std::vector<double> orders;
  while (true) {
    const std::string_view part = text.substr(0, text.find(','));
    double order = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), order);
    if (error != std::errc() || end != part.data() + part.size() ||
        !(order > 0 && order <= scope::most_order) || std::fmod(8 * order, 1) != 0)
      throw UsageError(fmt::format("--orders: '{}', allowed: multiples of 1/8 above 0 and up to {}", part,
                                   scope::most_order));
    orders.push_back(order);
    if (part.size() == text.size()) return orders;
    text.remove_prefix(part.size() + 1);
  }
}

void set_share(const po::variables_map& given, const char* name, double& share) {
  const auto percent = not_negative_number(given, name);
  if (!percent) return;
  if (!(*percent < 100))
    throw UsageError(fmt::format("--{}: {:g}, allowed: from 0 to below 100 (per cent)", name, *percent));
  share = *percent / 100;
}

std::optional<ComparedCell> compared_of(const po::variables_map& given) {
  if (given.count("compare") != given.count("cell"))
    throw UsageError(
        "--compare and --cell go together: rubscope RECORDING --compare CONFIG.yaml --cell 70,0.6");
  if (given.count("compare") == 0) {
    if (given.count("set")) throw UsageError("--set: allowed: with --compare");
    return std::nullopt;
  }
  ComparedCell compared{given["compare"].as<std::string>(), {}, read_cell(given["cell"].as<std::string>())};
  if (given.count("set")) compared.overrides = given["set"].as<std::vector<std::string>>();
  return compared;
}

}  // namespace

std::string rubscope_help() {
  return fmt::format(
      "rubscope RECORDING [options]\n"
      "Says what a recorded motion is: speed, orbit, lines, section, period, shape and whirl, and what noise "
      "and length leave open.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubscope measured.csv                               (with measured.yaml beside it)\n"
      "  rubscope export.txt --columns                       (what is in it: names, units, rate)\n"
      "  rubscope run7.wav --compare kit.yaml --cell 70,0.6\n"
      "  rubscope monday/run7.csv --instrument kit.yaml --output results/run7 --figure run7.png\n\n"
      "The file beside it, for example:\n"
      "  time: t\n"
      "  keyphasor: {{column: KP, mark: dark}}\n"
      "  probes:\n"
      "    - {{column: X, angle_deg: 45, gain_mv_per_um: 7.87}}\n"
      "    - {{column: Y, angle_deg: 135, gain_mv_per_um: 7.87}}\n\n"
      "Writes into DIR:\n"
      "  turns.csv      speed and position of the shaft at each passage of the mark: the section; its mean "
      "position\n"
      "  orbit.csv      the mean period, from the mark on; not of a run-up\n"
      "  lines.csv      lines of the full spectrum with phase and uncertainty; not of a run-up\n"
      "  bode.csv       amplitude and phase of some orders over time and speed\n"
      "  waterfall.csv  full spectra in orders, one after the other\n"
      "  measures.csv   period, sizes, noise, direction of whirl; of a run-up its rate and resonance\n"
      "  compared.csv, simulated.csv   with --compare: both motions' lines, and the simulated orbit\n\n"
      "Exit codes: 0 done; 1 usage; 2 a recording or its description that cannot be used; 3 input/output.\n",
      text_of(visible_options()));
}

RubscopeArguments parse_rubscope_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_recording_command_line(argc, argv, visible_options());
  RubscopeArguments arguments{recording_arguments(given, "rubscope RECORDING", "_scope")};
  if (arguments.action != Action::run) return arguments;
  arguments.columns = given.count("columns") > 0;
  if (given.count("orders")) arguments.orders = orders_of(given["orders"].as<std::string>());
  set_share(given, "least-line", arguments.thresholds.least_share);
  set_share(given, "most-modulation", arguments.thresholds.most_modulation);
  arguments.compared = compared_of(given);
  arguments.shown = shown_lengths_of(given);
  arguments.figure = figure_of(given);
  return arguments;
}

}  // namespace rubsweep::apps
