#include "rubsweep/config/unit_slips.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <variant>

#include "rubsweep/config/number.hpp"
#include "rubsweep/config/place_axes.hpp"
#include "rubsweep/config/text.hpp"

namespace rubsweep::config {
namespace {

constexpr double most_kick_periods = 100, most_speed_ratio = 100, most_gravity = 100, most_radius_m = 10;
constexpr double critical_damping = 1;

std::optional<Value> child(const std::optional<Value>& parent, std::string_view name) {
  if (!parent || parent->node.kind != Node::Kind::map) return std::nullopt;
  for (std::size_t i = 0; i < parent->node.keys.size(); ++i) {
    if (parent->node.keys[i].text == name) {
      return Value{parent->node.items[i], child_path(parent->path, name), parent->diagnostics};
    }
  }
  return std::nullopt;
}

std::optional<double> number(const std::optional<Value>& value) {
  if (!value || value->node.kind != Node::Kind::scalar) return std::nullopt;
  const ParsedNumber parsed = parse_number(value->node.text);
  return parsed.error == NumberError::none ? std::optional(parsed.value) : std::nullopt;
}

void check_stop(const Value& stop) {
  const auto clearance = child(stop, "clearance_m"), radius = child(stop, "contact_radius_m");
  const double clearance_m = number(clearance).value_or(0), radius_m = number(radius).value_or(0);
  if (radius_m > most_radius_m) {
    refuse(*radius, fmt::format("{} m is no radius of a shaft (millimetres?)", radius_m),
           fmt::format("at most {}", most_radius_m));
  } else if (radius_m > 0 && clearance_m >= radius_m) {
    refuse(*clearance, fmt::format("{} m is no less than contact_radius_m (millimetres?)", clearance_m),
           fmt::format("less than {}", radius_m));
  }
}

/// `slip` says what was meant if not the unit of the key, of which the natural frequency is `natural`.
struct SpeedUnit {
  std::string_view name, slip;
  double natural = 0;
};

void check_speed(const std::optional<Value>& speed, const SpeedUnit& unit) {
  const auto value = number(speed);
  if (!value || *value <= most_speed_ratio * unit.natural) return;
  refuse(*speed,
         fmt::format("{} {} is over {} times rotor.natural_frequency_hz{}", *value, unit.name,
                     most_speed_ratio, unit.slip),
         fmt::format("at most {}", most_speed_ratio * unit.natural));
}

/// A single number, both ends, or a list.
void check_speeds(const std::optional<Value>& axis, const SpeedUnit& unit) {
  check_speed(axis, unit);
  for (const std::string_view end : {"from", "to"}) check_speed(child(axis, end), unit);
  const auto values = child(axis, "values");
  if (!values) return;
  for (std::size_t i = 0; i < values->node.items.size(); ++i) {
    check_speed(Value{values->node.items[i], fmt::format("{}.{}", values->path, i), values->diagnostics},
                unit);
  }
}

void check_damping(const Value& ratio) {
  const double value = number(ratio).value_or(0);
  if (value < critical_damping) return;
  refuse(ratio, fmt::format("{} of critical damping leaves the rotor no vibration (per cent?)", value),
         fmt::format("less than {}", critical_damping));
}

void check_kick(const Value& duration, double natural_frequency_hz) {
  const double periods = number(duration).value_or(0) * natural_frequency_hz;
  if (periods <= most_kick_periods) return;
  refuse(duration, fmt::format("{} periods of the rotor are no kick (milliseconds?)", periods),
         fmt::format("at most {} = {} periods", most_kick_periods / natural_frequency_hz, most_kick_periods));
}

}  // namespace

void refuse_unit_slips(const Value& root) {
  const std::optional<Value> whole = root;
  if (const auto stops = child(whole, "stops")) {
    for (std::size_t i = 0; i < stops->node.items.size(); ++i) {
      check_stop({stops->node.items[i], fmt::format("stops.{}", i), stops->diagnostics});
    }
  }
  const auto rotor = child(whole, "rotor");
  // A Jeffcott rotor alone has one.
  if (const auto frequency_hz = number(child(rotor, "natural_frequency_hz"))) {
    for (const std::string_view name : {"damping_ratio", "rotating_damping_ratio"}) {
      if (const auto ratio = child(rotor, name)) check_damping(*ratio);
    }
    if (const auto duration = child(child(whole, "kick"), "duration_s")) check_kick(*duration, *frequency_hz);
    const auto sweep = child(whole, "sweep");
    check_speeds(child(sweep, "speed_hz"), {"Hz", " (revolutions per minute?)", *frequency_hz});
    check_speeds(child(sweep, "speed_rpm"), {"revolutions per minute", "", rpm_per_hz * *frequency_hz});
  }
  const auto gravity = child(whole, "gravity_m_per_s2");
  if (number(gravity).value_or(0) > most_gravity) {
    refuse(*gravity, fmt::format("{} m/s2 is no gravity (millimetres?)", *number(gravity)),
           fmt::format("at most {}", most_gravity));
  }
}

std::optional<double> most_speed_hz(const model::Machine& machine) {
  const auto* rotor = std::get_if<model::JeffcottRotor>(&machine.rotor);
  return rotor == nullptr ? std::nullopt : std::optional(most_speed_ratio * rotor->natural_frequency_hz);
}

}  // namespace rubsweep::config
