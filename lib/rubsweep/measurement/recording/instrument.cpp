#include "rubsweep/measurement/recording/instrument.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::recording {
namespace {

using rubsweep::recording::Instrument;
using rubsweep::recording::Keyphasor;
using rubsweep::recording::MachineGroup;
using rubsweep::recording::Mark;
using rubsweep::recording::Place;
using rubsweep::recording::Probe;
using rubsweep::recording::RunOut;
using rubsweep::recording::SpeedColumn;
using rubsweep::recording::Sweep;

constexpr std::string_view root_form =
    "a map with probes, keyphasor, speed_hz, speed or sweep, time or sampling_rate_hz";
constexpr Words<Mark, 2> marks{{"dark", "bright"}, {Mark::dark, Mark::bright}};

constexpr Words<Place, 3> places{{"shaft", "shaft_absolute", "casing"},
                                 {Place::shaft, Place::shaft_absolute, Place::casing}};
constexpr Words<MachineGroup, 4> groups{{"large_rigid", "large_flexible", "medium_rigid", "medium_flexible"},
                                        {MachineGroup::large_rigid, MachineGroup::large_flexible,
                                         MachineGroup::medium_rigid, MachineGroup::medium_flexible}};

constexpr int most_pulses = 4096;

/// Smallest angle between two probes, in degrees, the same as for simulated probes.
constexpr double least_angle_deg = 10;

void read_column(yaml::Section& section, std::string_view name, std::string& column) {
  if (const auto value = section.require(name, "the name of a column"))
    column = read_text(*value).value_or("");
}

Probe read_probe(const yaml::Value& value) {
  yaml::Section section(value);
  Probe probe;
  probe.angle_deg = model::required;
  read_column(section, "column", probe.column);
  section.field("angle_deg", probe.angle_deg, model::any_finite);
  const std::array gains{std::pair{"gain_mv_per_um", &probe.gain_mv_per_um},
                         std::pair{"gain_mv_per_mm_per_s", &probe.gain_mv_per_mm_per_s},
                         std::pair{"gain_mv_per_g", &probe.gain_mv_per_g}};
  int given = 0;
  for (const auto& [name, gain] : gains) {
    section.field(name, *gain, model::any_finite);
    if (*gain == 0) section.refuse(name, "is 0", "a number other than 0");
    if (*gain && ++given == 2) section.refuse(name, "is there beside another gain", "one");
  }
  if (section.find("on")) section.field("on", probe.on.emplace(), places);
  if (const auto unit = section.find("unit")) probe.unit = read_text(*unit);
  section.field("range_v", probe.range_v, model::positive);
  section.field("rest", probe.rest, model::any_finite);
  return probe;
}

Keyphasor read_keyphasor(const yaml::Value& value) {
  yaml::Section section(value);
  Keyphasor keyphasor;
  read_column(section, "column", keyphasor.column);
  section.field("mark", keyphasor.mark, marks);
  section.field("threshold", keyphasor.threshold, model::any_finite);
  section.field("hysteresis", keyphasor.hysteresis, model::not_negative);
  section.field("pulses_per_turn", keyphasor.pulses_per_turn, model::IntegerRange{1, most_pulses});
  return keyphasor;
}

/// Reads the name of the column, or a map with name and unit.
SpeedColumn read_speed(const yaml::Value& value) {
  SpeedColumn speed;
  if (value.node.kind != yaml::Node::Kind::map) {
    speed.column = read_text(value).value_or("");
    return speed;
  }
  yaml::Section section(value);
  read_column(section, "column", speed.column);
  if (const auto unit = section.find("unit")) speed.unit = read_text(*unit);
  return speed;
}

RunOut read_run_out(const yaml::Value& value) {
  yaml::Section section(value);
  RunOut run_out{model::required, model::required, false};
  section.field("from_s", run_out.from_s, model::any_finite);
  section.field("to_s", run_out.to_s, model::any_finite);
  constexpr Words<bool, 2> kinds{{"waveform", "vector"}, {false, true}};
  section.field("subtract", run_out.vector, kinds);
  return run_out;
}

void read_zones(yaml::Section& section, std::string_view name, std::optional<std::array<double, 3>>& limits) {
  const auto value = section.find(name);
  if (!value || !yaml::read_numbers(*value, limits.emplace())) return;
  const auto& [first, second, third] = *limits;
  if (!(first > 0 && first < second && second < third))
    yaml::refuse(*value, "holds no limits of the zones A, B and C", "three rising numbers > 0");
}

Sweep read_sweep(const yaml::Value& value) {
  yaml::Section section(value);
  Sweep sweep{model::required, model::required};
  section.field("from_hz", sweep.from_hz, model::positive);
  section.field("to_hz", sweep.to_hz, model::positive);
  return sweep;
}

Instrument read_root(const yaml::Value& root) {
  yaml::Section section(root, root_form);
  Instrument instrument;
  if (section.find("time") && section.find("sampling_rate_hz"))
    section.require_exactly_one({"time", "sampling_rate_hz"});
  section.require_exactly_one({"keyphasor", "speed_hz", "speed", "sweep"});
  if (const auto value = section.find("time")) instrument.time = read_text(*value);
  section.field("sampling_rate_hz", instrument.sampling_rate_hz, model::positive);
  section.field("speed_hz", instrument.speed_hz, model::positive);
  section.field("from_s", instrument.from_s, model::any_finite);
  section.field("to_s", instrument.to_s, model::any_finite);
  section.field("lowest_order", instrument.lowest_order, model::positive);
  if (section.find("machine_group"))
    section.field("machine_group", instrument.machine_group.emplace(), groups);
  read_zones(section, "zone_limits_mm_per_s", instrument.zone_limits_mm_per_s);
  read_zones(section, "zone_limits_um", instrument.zone_limits_um);
  if (const auto value = section.find("keyphasor")) instrument.keyphasor = read_keyphasor(*value);
  if (const auto value = section.find("speed")) instrument.speed = read_speed(*value);
  if (const auto value = section.find("sweep")) instrument.sweep = read_sweep(*value);
  if (const auto value = section.find("run_out")) instrument.run_out = read_run_out(*value);
  if (const auto value = section.require("probes", "a list of one or two maps")) {
    for (const yaml::Value& item : read_list(*value, 2)) instrument.probes.push_back(read_probe(item));
  }
  section.refuse_unknown_keys();
  if (section.is_sound() && instrument.run_out && !instrument.keyphasor)
    section.refuse_together("run_out", {"run_out", "speed_hz"}, "is there without a mark on the shaft",
                            "with keyphasor");
  if (section.is_sound() && instrument.probes.size() == 2 &&
      instrument.probes[0].rest.has_value() != instrument.probes[1].rest.has_value())
    section.refuse("probes", "have a reading at rest of one alone", "rest of both, or of none");
  if (section.is_sound() && instrument.probes.size() == 2) {
    const double apart_rad =
        (instrument.probes[1].angle_deg - instrument.probes[0].angle_deg) * std::numbers::pi / 180;
    if (std::abs(std::sin(apart_rad)) < std::sin(least_angle_deg * std::numbers::pi / 180)) {
      section.refuse("probes", "look along one line",
                     fmt::format("directions {} degrees or more off each other's line", least_angle_deg));
    }
  }
  return instrument;
}

}  // namespace

Instrument read_instrument_text(std::string_view text, const std::string& name) {
  return read_parsed(text, name, root_form, {}, read_root);
}

}  // namespace rubsweep::config::recording
