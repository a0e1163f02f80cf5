#include "speed_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/range.hpp"
#include "shared/command_line.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

/// The finite numbers between the colons of a text; empty where one of them is invalid.
std::optional<std::vector<double>> numbers_between_colons(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string_view part : parts_of(text, ':')) {
    std::size_t used = 0;
    try {
      numbers.push_back(std::stod(std::string(part), &used));
    } catch (const std::logic_error&) {
      return std::nullopt;
    }
    if (used != part.size() || !model::contains(model::any_finite, numbers.back())) return std::nullopt;
  }
  return numbers;
}

}  // namespace

ramp::SpeedRamp ramp_of(const std::string& text) {
  const auto numbers = numbers_between_colons(text);
  if (!numbers || numbers->size() != 3) {
    throw UsageError(
        fmt::format("--run-up: '{}' is not allowed, allowed: FROM:TO:RATE, three numbers", text));
  }
  const ramp::SpeedRamp ramp{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  if (ramp.from_hz <= 0 || ramp.to_hz <= 0 || (ramp.to_hz - ramp.from_hz) * ramp.rate_hz_per_s <= 0) {
    throw UsageError("--run-up: allowed: speeds > 0, and a rate that leads from the first to the second");
  }
  return ramp;
}

CampbellSpeeds campbell_speeds_of(const std::string& text) {
  constexpr double most = 10000;
  const auto numbers = numbers_between_colons(text);
  CampbellSpeeds speeds;
  bool good = numbers && (numbers->size() == 2 || numbers->size() == 3);
  if (good && numbers->size() == 3) {
    const double count = (*numbers)[2];
    good = count >= 2 && count <= most && count == std::floor(count);
    if (good) speeds.count = static_cast<int>(count);
  }
  if (good) {
    speeds.from_hz = (*numbers)[0];
    speeds.to_hz = (*numbers)[1];
    good = speeds.from_hz >= 0 && speeds.to_hz > speeds.from_hz;
  }
  if (good) return speeds;
  throw UsageError(
      fmt::format("--campbell: '{}' is not allowed, allowed: FROM:TO or FROM:TO:COUNT with 0 <= FROM < TO "
                  "and a COUNT from 2 to "
                  "{}",
                  text, most));
}

design::SpeedRange operating_range_of(const char* option, const std::string& text, double per_hz) {
  const auto numbers = numbers_between_colons(text);
  if (!numbers || numbers->size() != 2 || (*numbers)[0] <= 0 || (*numbers)[1] <= (*numbers)[0]) {
    throw UsageError(
        fmt::format("--{}: '{}' is not allowed, allowed: FROM:TO with 0 < FROM < TO", option, text));
  }
  return {(*numbers)[0] / per_hz, (*numbers)[1] / per_hz};
}

std::vector<design::Stage> stages_of(const std::vector<std::string>& texts) {
  constexpr double watts = 1e3, metres = 1e-3;
  if (texts == std::vector<std::string>{"none"}) return {};
  std::vector<design::Stage> stages;
  for (const std::string& text : texts) {
    const std::size_t colon = text.find(':');
    const std::string kind = text.substr(0, colon);
    const bool blades = kind == "blades";
    const auto numbers =
        colon == std::string::npos ? std::nullopt : numbers_between_colons(text.substr(colon + 1));
    const bool sound = (blades || kind == "impeller") && numbers && numbers->size() == (blades ? 3 : 4) &&
                       std::ranges::all_of(*numbers, [](double number) { return number > 0; });
    if (!sound)
      throw UsageError(fmt::format(
          "--stage: '{}' is not allowed, allowed: impeller:KW:DENSITY_RATIO:DIAMETER_MM:WIDTH_MM, "
          "blades:KW:DIAMETER_MM:HEIGHT_MM with numbers > 0, or none alone",
          text));
    const std::vector<double>& given = *numbers;
    stages.push_back({blades, watts * given[0], blades ? 1 : given[1], metres * given[given.size() - 2],
                      metres * given.back()});
  }
  return stages;
}

}  // namespace rubsweep::apps
