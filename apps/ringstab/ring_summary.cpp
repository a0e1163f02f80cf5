#include "ring_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>

namespace rubsweep::apps {

using namespace ring;

namespace {

double rpm(double rad_per_s) { return rad_per_s / rad_per_s_of_rpm; }

std::string_view to_string(Motion motion) {
  if (motion == Motion::both) return "both motions";
  return motion == Motion::radial ? "radial motion only" : "tangential motion only";
}

std::string explain_load(const Load& load, std::size_t index) {
  const double radial = std::sqrt(load.radial_stiffness_n_per_m / load.radial_mass_kg);
  const double tangential =
      std::sqrt(load.tangential_stiffness_n_per_m / (load.flexural_mass_kg - load.rotary_mass_kg));
  std::string text = fmt::format("load {}: {} at {} deg, inclined by {} deg, {}", index,
                                 load.kind == LoadKind::beam ? "beam" : "spring-mass", load.angle_deg,
                                 load.inclination_deg, to_string(load.motion));
  if (load.motion != Motion::tangential && load.radial_mass_kg > 0) {
    text += fmt::format(", radial {:.6g} rad/s", radial);
  }
  if (load.motion != Motion::radial) text += fmt::format(", softened to zero at {:.6g} rad/s", tangential);
  return text + "\n";
}

}  // namespace

std::string ring_summary(const Study& study, const Analysis& analysis) {
  std::string text =
      fmt::format("speed     {:g} to {:g} rpm, friction coefficient {:g}\n", study.speeds_rpm.front(),
                  study.speeds_rpm.back(), study.system.friction_coefficient);
  for (const Regime& regime : analysis.regimes) {
    text += fmt::format("{:>10.3f} to {:>10.3f} rpm  {}\n", rpm(regime.from_rad_per_s),
                        rpm(regime.to_rad_per_s), regime.text);
  }
  text += "onsets\n";
  for (const Onset& onset : analysis.onsets) {
    if (onset.kind.starts_with("stable")) continue;
    text += fmt::format("{:>14.6f} rpm  {:<16}  {}{}\n", rpm(onset.speed_rad_per_s), onset.kind,
                        fmt::join(onset.modes, " + "), onset.note.empty() ? "" : " (" + onset.note + ")");
  }
  text += "closed forms\n";
  for (const CriticalSpeed& speed : analysis.critical_speeds) {
    text +=
        fmt::format("{:>14.6f} rpm  {:<20}  {}\n", rpm(speed.closed_form_rad_per_s), speed.name,
                    speed.numeric_rad_per_s
                        ? fmt::format("found at a relative distance of {:.1e}",
                                      std::abs(*speed.numeric_rad_per_s / speed.closed_form_rad_per_s - 1))
                        : "nothing there in this range");
  }
  return text;
}

std::string validity_summary(const Study& study, const std::vector<StaticLoad>& loads) {
  std::string ranges;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (loads[i].valid()) continue;
    std::size_t last = i;
    while (last + 1 < loads.size() && !loads[last + 1].valid()) ++last;
    ranges += fmt::format("{}{:g} to {:g}", ranges.empty() ? "" : ", ", study.speeds_rpm[i],
                          study.speeds_rpm[last]);
    i = last;
  }
  if (ranges.empty()) return "contact   every load presses and slips forward at every speed\n";
  return "contact   a load lifts off or its slip reverses (the linear model does not hold) at rpm " + ranges +
         "\n";
}

std::string chart_summary(const std::vector<std::optional<ChartLine>>& lines) {
  if (lines.empty()) return "";
  std::size_t points = 0, stable = 0;
  std::map<std::string, int> failed;
  for (const auto& line : lines) {
    if (line && line->status != "ok") ++failed[line->status];
    if (!line) continue;
    points += line->points.size();
    for (const ChartPoint& point : line->points) {
      if (point.signature.stable()) ++stable;
    }
  }
  std::string text =
      fmt::format("chart     {} lines, {} points, {:.1f} % stable\n", lines.size(), points,
                  points > 0 ? 100.0 * static_cast<double>(stable) / static_cast<double>(points) : 0);
  for (const auto& [status, count] : failed) text += fmt::format("{:>8}  lines {}\n", count, status);
  return text;
}

std::string explain_ring(const Study& study) {
  const System& system = study.system;
  std::string text = fmt::format(
      "ring: mode of {} nodal diameters, {:.6g} rad/s, critical speed {:.6g} rpm; inextensible, in plane, "
      "one mode\n",
      system.ring.nodal_diameters, system.ring.nodal_diameters * critical_speed(system.ring),
      rpm(critical_speed(system.ring)));
  for (std::size_t j = 0; j < system.loads.size(); ++j) text += explain_load(system.loads[j], j);
  text += fmt::format(
      "friction: coefficient {:g} on every load, its direction never changes; no damping\n"
      "static load: {}\n"
      "solver: eigenvalues of the scaled first-order form; onsets by bisection of the root count, then "
      "polished\n"
      "speed: {} values from {:g} to {:g} rpm\n",
      system.friction_coefficient,
      system.ring.radius_m ? "by centrifugal force and preload, lift-off and slip reversal are marked"
                           : "not known without ring.radius_m, lift-off is not checked",
      study.speeds_rpm.size(), study.speeds_rpm.front(), study.speeds_rpm.back());
  if (study.chart) {
    text += fmt::format("chart: {} values of {} of {}\n", study.chart->values.size(),
                        to_string(study.chart->parameter),
                        study.chart->load ? fmt::format("load {}", *study.chart->load) : "every load");
  }
  return text;
}

}  // namespace rubsweep::apps
