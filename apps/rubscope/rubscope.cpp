#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/batch/input_file.hpp"
#include "rubsweep/batch/result_files.hpp"
#include "rubsweep/config/file.hpp"
#include "rubsweep/config/recording/read_instrument.hpp"
#include "rubsweep/config/study_digest.hpp"
#include "rubsweep/recording/recording.hpp"
#include "rubsweep/recording/recording_file.hpp"
#include "rubsweep/scope/scope_tables.hpp"
#include "shared/command_line.hpp"
#include "shared/exit_code.hpp"
#include "shared/figure.hpp"
#include "shared/interrupt.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// Every file that a run may leave.
constexpr std::array<std::string_view, 4> file_names{"turns.csv", "orbit.csv", "lines.csv", "measures.csv"};

po::options_description visible_options() {
  po::options_description options("Options");
  options.add_options()(
      "instrument", po::value<std::string>()->value_name("FILE.yaml"),
      "probes, keyphasor and clock of the recording instead of RECORDING with the ending .yaml");
  add_output(options, "write there instead of into RECORDING without its ending and with _scope");
  add_figure(options, "draw orbit, section, lines and speed");
  add_last(options);
  return options;
}

std::string help() {
  return fmt::format(
      "rubscope RECORDING.csv [options]\n"
      "Says what a recorded motion is: speed, orbit, lines, section, period, shape and whirl, and what noise "
      "and "
      "length leave open.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubscope measured.csv                               (with measured.yaml beside it)\n"
      "  rubscope monday/run7.csv --instrument kit.yaml --output results/run7 --figure run7.png\n\n"
      "The file beside it, for example:\n"
      "  time: t\n"
      "  keyphasor: {{column: KP, mark: dark}}\n"
      "  probes:\n"
      "    - {{column: X, angle_deg: 45, gain_mv_per_um: 7.87}}\n"
      "    - {{column: Y, angle_deg: 135, gain_mv_per_um: 7.87}}\n\n"
      "Writes into DIR:\n"
      "  turns.csv      speed and position of the shaft at each passage of the mark: the section\n"
      "  orbit.csv      the mean period, from the mark on\n"
      "  lines.csv      lines of the full spectrum with phase and uncertainty\n"
      "  measures.csv   period, sizes, noise, direction of whirl\n\n"
      "Exit codes: 0 done; 1 usage; 2 a recording or its description that cannot be used; 3 input/output.\n",
      text_of(visible_options()));
}

po::variables_map parse(int argc, char** argv) {
  po::options_description all = visible_options();
  all.add_options()("recording", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("recording", -1);
  return read_command_line(argc, argv, all, positional);
}

fs::path recording_of(const po::variables_map& given) {
  const auto names = given.count("recording") ? given["recording"].as<std::vector<std::string>>()
                                              : std::vector<std::string>{};
  if (names.size() != 1) throw UsageError("one recording is needed: rubscope RECORDING.csv");
  return names.front();
}

int look(const po::variables_map& given) {
  const fs::path file = recording_of(given);
  fs::path beside = file, directory = file;
  beside.replace_extension(".yaml");
  directory.replace_extension();
  directory += "_scope";
  if (given.count("instrument")) beside = given["instrument"].as<std::string>();
  if (given.count("output")) directory = given["output"].as<std::string>();
  const std::optional<Figure> figure = figure_of(given);
  const std::string description = config::read_config_bytes(beside);
  const recording::Instrument instrument =
      config::recording::read_instrument_text(description, beside.string());
  const std::string text = batch::read_input(file);
  const recording::Channels channels = recording::read_recording_file(file, text);
  const recording::Recording recording = recording::make_recording(channels, instrument, file.string());
  const scope::Verdict verdict =
      scope::judge(recording.displacement_m, recording::samples_per_revolution, recording.plane);
  scope::ScopeTables tables = scope::tables_of(recording, verdict);
  const ResultDirectory made(directory, file_names);
  end_on_interrupts("nothing was written");
  const batch::ResultFiles files{{"turns.csv", std::move(tables.turns_csv)},
                                 {"orbit.csv", std::move(tables.orbit_csv)},
                                 {"lines.csv", std::move(tables.lines_csv)},
                                 {"measures.csv", std::move(tables.measures_csv)}};
  batch::write_result_files(files, file_names, directory,
                            {"rubscope", config::digest_of(description + text), {}});
  if (!given.count("quiet")) print("{}{}", tables.summary, batch::files_line(files, directory));
  if (figure) {
    figure->draw("scope", directory, file.filename().string());
    if (!given.count("quiet")) print("figure    {}\n", figure->file().string());
  }
  return done;
}

int perform(const po::variables_map& given) {
  if (answered("rubscope", action_of(given), help)) return done;
  return look(given);
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubscope", [&] { return perform(parse(argc, argv)); });
}
