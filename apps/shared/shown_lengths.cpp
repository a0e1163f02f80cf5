#include "shared/shown_lengths.hpp"

#include <fmt/format.h>

#include "shared/program.hpp"

namespace rubsweep::apps {

void add_shown_lengths(po::options_description& options) {
  options.add_options()(
      "length-unit", po::value<std::string>()->value_name("UNIT"),
      "mm, um or mil (a thousandth of an inch) for displacements in text and figure; tables stay in m")(
      "peak-to-peak", "amplitudes in text and figure as twice their size, as vibration is often given");
}

model::ShownLengths shown_lengths_of(const po::variables_map& given) {
  model::ShownLengths shown{.peak_to_peak = given.count("peak-to-peak") != 0};
  if (given.count("length-unit") == 0) return shown;
  const auto& word = given["length-unit"].as<std::string>();
  shown.unit = model::length_unit_of(word);
  if (!shown.unit)
    throw UsageError(fmt::format("--length-unit: '{}' is not allowed, allowed: mm, um, mil", word));
  return shown;
}

std::vector<std::string> drawn_lengths(const model::ShownLengths& shown, bool has_length_unit,
                                       bool has_peak_to_peak) {
  std::vector<std::string> options;
  if (shown.unit && has_length_unit) options = {"--length-unit", std::string(model::word_of(*shown.unit))};
  if (shown.peak_to_peak && has_peak_to_peak) options.emplace_back("--peak-to-peak");
  return options;
}

}  // namespace rubsweep::apps
