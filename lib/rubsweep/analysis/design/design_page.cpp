#include "rubsweep/analysis/design/design_page.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "rubsweep/core/model/speed_text.hpp"

namespace rubsweep::design {
namespace {

std::string_view verdict(bool met) { return met ? "ok" : "NOT MET"; }

std::string speed(double hz) { return model::speed_text(hz, 5); }

std::string at(const std::optional<double>& position_m) {
  return position_m ? fmt::format(" at {:.4g} m", *position_m) : "";
}

/// Lengths on the page.
class Lengths {
 public:
  explicit Lengths(const model::ShownLengths& shown) : shown_(shown) {}
  std::string operator()(double length_m) const {
    return model::length_text(length_m, shown_, model::LengthUnit::um);
  }

 private:
  model::ShownLengths shown_;
};

/// The response of a rotor that grows does not last: that it keeps a limit means nothing.
std::string_view if_lasting(bool met, const linear::GrowthAt& growth) {
  return met && growth.growth_per_s > 0 ? "of a motion that does not last" : verdict(met);
}

std::string stability_lines(const DesignCheck& check) {
  if (check.growth.growth_per_s == 0)
    return "stability every free vibration decays in the operating range: ok\n";
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
    text += fmt::format("  probe {}{}: {} at {}: {}\n", k, at(probe.position_m),
                        length(probe.major_axis_m.value), speed(probe.major_axis_m.speed_hz),
                        if_lasting(probe.major_axis_m.value <= check.vibration_limit_m, check.growth));
  }
  return text + fmt::format("scale     x {:.4g}{}, eccentricity {} in all that follows\n", check.scale,
                            end_of_scale(check.scale), length(check.scale * check.eccentricity_m));
}

std::string clearance_lines(const DesignCheck& check, const Lengths& length) {
  std::string text = fmt::format("clearance major axis against {:.4g} % of the diametral clearance\n",
                                 100 * clearance_share);
  for (const ClearanceMargin& one : check.clearances) {
    if (one.diametral_clearance_m == 0) {
      text += fmt::format("  stop {}{}: the rotor rests on it at {}: NOT MET\n", one.stop, at(one.position_m),
                          speed(one.speed_hz));
      continue;
    }
    text +=
        fmt::format("  stop {}{}: {} of {} at {}, margin {:.1f} %: {}\n", one.stop, at(one.position_m),
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
      text += fmt::format("  stop {}: none at any friction: ok\n", one.stop);
      continue;
    }
    text +=
        fmt::format("  stop {}: friction {:.4g} of {:.4g}, {:.4g} Hz backward at {}, margin {:.1f} %: {}\n",
                    one.stop, one.friction, one.needs->least_friction, one.needs->whirl_hz,
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

}  // namespace

std::string design_page(const DesignCheck& check, const model::ShownLengths& shown) {
  const Lengths length(shown);
  return fmt::format("operating {} to {}, clearances from {} on\n", speed(check.operating.from_hz),
                     speed(check.operating.to_hz), speed(check.whole.from_hz)) +
         stability_lines(check) + vibration_lines(check, length) + clearance_lines(check, length) +
         whip_lines(check) + lock_lines(check) + kick_lines(check);
}

}  // namespace rubsweep::design
