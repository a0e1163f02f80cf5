#include "rubsweep/analysis/design/design_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "rubsweep/analysis/design/design_terms.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/model/speed_text.hpp"

namespace rubsweep::design {
namespace {

using model::in_brackets;

std::string_view verdict(bool met) { return met ? "ok" : "NOT MET"; }

std::string speed(double hz) { return model::speed_text(hz, 5); }

std::string at(const std::optional<double>& position_m) {
  return position_m ? fmt::format(" at {:.4g} m", *position_m) : "";
}

/// Prints a length of the page in its unit.
using Lengths = std::function<std::string(double)>;

/// Verdict for a limit. While a free vibration grows, the steady response does not last, so that a limit
/// which is met says nothing.
std::string_view if_lasting(bool met, const linear::GrowthAt& growth) {
  return met && growth.growth_per_s > 0 ? "of a motion that does not last" : verdict(met);
}

std::string stability_lines(const DesignCheck& check) {
  if (check.growth.growth_per_s == 0) {
    std::string text = "stability every free vibration decays in the operating range: ok\n";
    if (!check.decays_to_hz) return text;
    return text + fmt::format("          above {} one grows, by up to {:.4g} 1/s at {}\n",
                              speed(*check.decays_to_hz), check.growth_beyond.growth_per_s,
                              speed(check.growth_beyond.speed_hz));
  }
  return fmt::format("stability a free vibration grows by {:.4g} 1/s at {}: NOT MET\n",
                     check.growth.growth_per_s, speed(check.growth.speed_hz));
}

std::string_view end_of_scale(double scale) {
  if (scale == largest_scale_factor) return ", the most";
  return scale == smallest_scale_factor ? ", the least" : "";
}

std::string vibration_lines(const DesignCheck& check, const Lengths& length) {
  std::string text =
      fmt::format("vibration {} peak to peak allowed at the probes\n", length(check.vibration_limit_m));
  text += fmt::format("unbalance eccentricity {}\n", length(check.eccentricity_m));
  for (std::size_t k = 0; k < check.probes.size(); ++k) {
    const ProbeResponse& probe = check.probes[k];
    text += fmt::format("  probe {}{}{}: {} at {}: {}\n", k, in_brackets(probe.name), at(probe.position_m),
                        length(probe.major_axis_m.value), speed(probe.major_axis_m.speed_hz),
                        if_lasting(probe.major_axis_m.value <= check.vibration_limit_m, check.growth));
  }
  return text + fmt::format("scale     x {:.4g}{}, eccentricity {} in all that follows\n", check.scale,
                            end_of_scale(check.scale), length(check.scale * check.eccentricity_m));
}

std::string stop_in(const DesignCheck& check, std::size_t stop) {
  return fmt::format("stop {}{}", stop, in_brackets(model::name_at(check.stop_names, stop)));
}

std::string clearance_lines(const DesignCheck& check, const Lengths& length) {
  std::string text = fmt::format("clearance major axis against {:.4g} % of the diametral clearance\n",
                                 100 * clearance_share);
  for (const ClearanceMargin& one : check.clearances) {
    const std::string stop = stop_in(check, one.stop);
    if (one.diametral_clearance_m == 0) {
      text += fmt::format("  {}{}: the rotor rests on it at {}: NOT MET\n", stop, at(one.position_m),
                          speed(one.speed_hz));
      continue;
    }
    text +=
        fmt::format("  {}{}: {} of {} at {}, margin {:.1f} %: {}\n", stop, at(one.position_m),
                    length(one.major_axis_m), length(clearance_share * one.diametral_clearance_m),
                    speed(one.speed_hz), 100 * one.margin, if_lasting(one.margin >= 0, check.whole_growth));
  }
  return text;
}

std::string whip_lines(const DesignCheck& check) {
  std::string text = "dry whip  friction against the least that keeps it going\n";
  if (check.whips.empty()) text += "  no annular stop\n";
  for (const WhipMargin& one : check.whips) {
    if (!one.needs) {
      text += fmt::format("  {}: none at any friction: ok\n", stop_in(check, one.stop));
      continue;
    }
    text +=
        fmt::format("  {}: friction {:.4g} of {:.4g}, {:.4g} Hz backward at {}, margin {:.1f} %: {}\n",
                    stop_in(check, one.stop), one.friction, one.needs->least_friction, one.needs->whirl_hz,
                    speed(one.needs->speed_hz), 100 * one.margin(), verdict(one.margin() > 0));
  }
  return text;
}

std::string lock_lines(const DesignCheck& check) {
  std::string text = "lock      speeds at which two modes can lock into a bouncing rub\n";
  for (const linear::LockSpeed& lock : check.locks)
    text += fmt::format("  {}: {} turns of mode {} to {} of mode {} in the turning frame\n",
                        speed(lock.speed_hz), lock.p, lock.first, lock.q, lock.second);
  return check.locks.empty() ? text + "  none in the operating range\n" : text;
}

std::string kick_lines(const DesignCheck& check) {
  std::string text = "kick      the smallest that starts a lasting rub\n";
  if (!check.no_kicks.empty()) return text + fmt::format("  not tried: {}\n", check.no_kicks);
  std::size_t runs = 0, failed = 0;
  for (const KickThreshold& kick : check.kicks) {
    runs += kick.runs;
    failed += kick.failed;
  }
  const KickThreshold* smallest = check.smallest_kick();
  if (smallest == nullptr)
    text += fmt::format("  none at any of {} speeds\n", check.kicks.size());
  else if (*smallest->force_n == 0)
    text += fmt::format("  none is needed at {}: {}\n", speed(smallest->speed_hz), smallest->motion);
  else
    text += fmt::format("  {:.4g} N at {}: {}\n", *smallest->force_n, speed(smallest->speed_hz),
                        smallest->motion);
  return text + fmt::format("  {} runs at {} speeds{}\n", runs, check.kicks.size(),
                            failed > 0 ? fmt::format(", {} failed", failed) : "");
}

std::string name_of(const Term& term) {
  std::string name = term.check;
  std::ranges::replace(name, '_', ' ');
  if (!term.place.empty()) name += ", " + term.place;
  name += in_brackets(term.name);
  return term.speed_hz ? name + " at " + speed(*term.speed_hz) : name;
}

/// Verdict of the whole check, and the three terms that come nearest to their limits.
std::string answer_lines(const DesignCheck& check) {
  constexpr std::size_t shown = 3;
  std::vector<Term> terms = terms_of(check);
  const auto broken = std::ranges::count_if(terms, [](const Term& term) { return term.met == false; });
  const auto unknown = std::ranges::count_if(terms, [](const Term& term) { return !term.not_told.empty(); });
  std::string text = "answer    ";
  switch (answer_of(check)) {
    case Answer::pass: text += "pass\n"; break;
    case Answer::not_met: text += fmt::format("NOT MET: {} of {} terms\n", broken, terms.size()); break;
    case Answer::not_told: text += fmt::format("not told: nothing is known of {} terms\n", unknown); break;
  }
  std::erase_if(terms, [](const Term& term) { return !term.margin || !term.met; });
  std::ranges::stable_sort(terms, {}, [](const Term& term) { return *term.margin; });
  for (std::size_t k = 0; k < std::min(shown, terms.size()); ++k)
    text += fmt::format("  margin {:.1f} %: {}: {}\n", 100 * *terms[k].margin, name_of(terms[k]),
                        verdict(*terms[k].met));
  return text;
}

/// A line for a term of the lateral analysis; lengths in the unit of the page.
std::string lateral_line(const Term& term, const Lengths& length) {
  const auto number = [&](double value) {
    return term.unit == "m" ? length(value)
                            : fmt::format("{:.5g}{}", value, term.unit == "1" ? "" : " " + term.unit);
  };
  std::string text = "  " + name_of(term) + at(term.position_m) + ": ";
  if (!term.not_told.empty()) return text + "not told: " + term.not_told + "\n";
  if (term.value) text += number(*term.value);
  if (term.limit) text += ", limit " + number(*term.limit);
  if (term.margin) text += fmt::format(", margin {:.1f} %", 100 * *term.margin);
  if (term.met) text += fmt::format(": {}", verdict(*term.met));
  return text + "\n";
}

std::string lateral_lines(const DesignCheck& check, const Lengths& length) {
  if (check.lateral.empty()) return {};
  std::string text =
      "lateral   response to unbalances, separation margins, decrements (API 617, API RP 684)\n";
  for (const Term& term : check.lateral) text += lateral_line(term, length);
  return text;
}

}  // namespace

std::string design_page(const DesignCheck& check, const model::ShownLengths& shown) {
  const Lengths length = [&](double length_m) {
    return model::length_text(length_m, shown, model::LengthUnit::um);
  };
  return answer_lines(check) +
         fmt::format("operating {} to {}, clearances from {} on\n", speed(check.operating.from_hz),
                     speed(check.operating.to_hz), speed(check.whole.from_hz)) +
         stability_lines(check) + vibration_lines(check, length) + clearance_lines(check, length) +
         whip_lines(check) + lateral_lines(check, length) + lock_lines(check) + kick_lines(check);
}

}  // namespace rubsweep::design
