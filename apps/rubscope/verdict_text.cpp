#include "rubscope/verdict_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rubsweep::apps {

using namespace scope;
using model::LengthUnit;

std::string motion_text(const Verdict& verdict) {
  if (!verdict.period) {
    return fmt::format("{}: repeats after no number of turns up to {}", to_string(verdict.motion),
                       verdict.longest_period);
  }
  std::string text(to_string(verdict.motion));
  if (*verdict.period > 1) text += fmt::format(" 1/{}", *verdict.period);
  if (verdict.shape)
    text += fmt::format(", {} orbit, {} whirl", to_string(*verdict.shape), to_string(*verdict.whirl));
  return text;
}

std::string doubt_text(const Verdict& verdict, double mean_speed_hz, const model::ShownLengths& shown) {
  const auto line = [&](double amplitude_m) {
    return model::amplitude_text(amplitude_m, shown, LengthUnit::um, 2);
  };
  if (const auto& doubt = verdict.doubtful) {
    return fmt::format("1/{} or 1/{}: {:.2g} s more would tell (a line of {}, seen from {} on)\n",
                       *verdict.period, doubt->turns, std::max(doubt->more_turns, 1.0) / mean_speed_hz,
                       line(doubt->amplitude_m), line(verdict.visible_m));
  }
  if (may_be_torus(verdict))
    return fmt::format(
        "1/{0} or a torus: its lines may stand {1:.1g}X beside multiples of 1/{0}; a longer recording would "
        "tell\n",
        *verdict.period, *verdict.order_room);
  if (verdict.longest_period < max_period)
    return fmt::format(
        "periods of more than {} turns cannot be told by {} turns; {:.2g} s more would tell up to {}\n",
        verdict.longest_period, verdict.turns, (3 * max_period - verdict.turns) / mean_speed_hz, max_period);
  if (!verdict.period)
    return fmt::format("lines of {} or more stand beside every period\n", line(verdict.visible_m));
  return fmt::format("no line of {} or more belongs to another period\n", line(verdict.visible_m));
}

std::string content_text(const Verdict& verdict, const model::ShownLengths& shown) {
  const auto length = [&](double amplitude_m, int digits) {
    return model::amplitude_text(amplitude_m, shown, LengthUnit::um, digits);
  };
  if (verdict.motion == MeasuredClass::at_rest) return {};
  std::string text;
  if (!verdict.period) {
    constexpr std::size_t most_said = 4;
    for (std::size_t k = 0; k < std::min(most_said, verdict.discrete_lines.size()); ++k) {
      const DiscreteLine& line = verdict.discrete_lines[k];
      text += fmt::format("{} {:+.6g}X +- {:.1g}, {} +- {}\n", k == 0 ? "lines    " : "         ", line.order,
                          line.order_uncertainty, length(line.amplitude_m, 4),
                          length(line.amplitude_uncertainty_m, 2));
    }
  }
  double largest_m = 0, size_m = 0;
  for (const MeasuredLine& line : verdict.lines) {
    if (line.order == 0) continue;
    largest_m = std::max(largest_m, std::abs(line.amplitude_m));
    size_m = std::hypot(size_m, std::abs(line.amplitude_m));
  }
  const auto percent = [](double amplitude_m, double whole_m) {
    return fmt::format("{:.2g} %", 100 * amplitude_m / whole_m);
  };
  const std::string most = fmt::format("{:.3g} %", 100 * verdict.thresholds.most_modulation);
  if (!verdict.period) {
    if (verdict.refused_modulation_m > verdict.visible_m)
      text += fmt::format(
          "unsteady  whole orders vary slowly by {} of the motion; up to {}, and twice that of one line, is "
          "called by the period\n",
          percent(verdict.refused_modulation_m, size_m), most);
    return text;
  }
  text = fmt::format("unsteady  lines vary slowly by {} of the motion, {} may be",
                     percent(verdict.modulation_m, size_m), most);
  if (verdict.beside_m > verdict.seen_m)
    text += fmt::format(
        "; beside the period stands a line of {}, {} of the largest one, too small to count below {:.3g} %",
        length(verdict.beside_m, 2), percent(verdict.beside_m, largest_m),
        100 * verdict.thresholds.least_share);
  return text + '\n';
}

}  // namespace rubsweep::apps
