#include "rubsweep/core/model/machine.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <type_traits>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/require.hpp"
#include "rubsweep/core/model/shaft_end.hpp"
#include "rubsweep/core/overloaded.hpp"

namespace rubsweep::model {
namespace {

auto requiring(std::string prefix) {
  return [prefix = std::move(prefix)](const char* name, const auto& value, const Range& range) {
    require(prefix + name, value, range);
  };
}

void validate(const Friction& friction, const std::string& path) {
  std::visit(
      overloaded{[&](const FallingFriction& law) {
                   FallingFriction::visit_numbers(law, requiring(path));
                   const auto [low, high, even] = FallingFriction::exponents;
                   if (law.exponent < low || law.exponent > high)
                     throw ConfigError(fmt::format("{}exponent: {}, allowed: an integer from {} to {}", path,
                                                   law.exponent, low, high));
                 },
                 [&](const auto& law) { std::decay_t<decltype(law)>::visit_fields(law, requiring(path)); }},
      friction);
  if (const auto bounds = holding_and_sliding(friction); bounds[0] < bounds[1])
    throw ConfigError(path +
                      "static: below the sliding friction, allowed: a number no less than coefficient");
}

void validate(const ContactDamping& damping, const std::string& path) {
  std::visit([&](const auto& given) { std::decay_t<decltype(given)>::visit_fields(given, requiring(path)); },
             damping);
}

void validate(const OneSideGeometry& flat, double, const std::string& path) {
  OneSideGeometry::visit_fields(flat, requiring(path));
}

void validate(const AnnularGeometry& annular, double clearance_m, const std::string& path) {
  for (const double component : annular.offset_m) require(path + "offset_m", component, any_finite);
  if (std::hypot(annular.offset_m[0], annular.offset_m[1]) >= clearance_m) {
    throw ConfigError(fmt::format(
        "{}offset_m: the rest position is not inside the annular stop, allowed: shorter than {}clearance_m",
        path, path));
  }
}

void validate(const Stop& stop, const std::string& path) {
  std::visit([&](const auto& geometry) { validate(geometry, stop.clearance_m, path); }, stop.geometry);
  Stop::visit_fields(stop, requiring(path));
  Stop::visit_mass(stop, requiring(path));
  if (stop.law.linear()) validate(stop.damping, path);
  validate(stop.law, stop.hertz.has_value(), path + "law.");
  validate(stop.friction, path + "friction.");
  if (stop.casing) Casing::visit_fields(*stop.casing, requiring(path + "casing."));
}

void validate(const Start& start, const Machine& machine) {
  BodyState::visit_fields(start.rotor, requiring("start."));
  for (std::size_t i = 0; i < start.casings.size(); ++i) {
    if (!start.casings[i]) continue;
    const std::string path = fmt::format("start.casings.{}", i);
    if (i >= machine.stops.size() || !machine.stops[i].casing)
      throw ConfigError(path + ": there is no such casing, or it is rigid, allowed: a casing that moves");
    BodyState::visit_fields(*start.casings[i], requiring(path + "."));
  }
  if (machine.kick) throw ConfigError("start: is given beside a kick, allowed: one of the two");
}

/// Checks a position along the shaft: a rotor kit has one, a Jeffcott rotor must not.
void validate_position(const Machine& machine, const std::optional<double>& position_m, bool needed,
                       const std::string& path) {
  const RotorKit* kit = kit_of(machine);
  if (kit == nullptr) {
    if (position_m)
      throw ConfigError(path + ": a Jeffcott rotor has no places along its shaft, allowed: nothing");
  } else if (position_m || needed) {
    require(path, position_m.value_or(required),
            Range{.low = 0, .high = furthest_place_m(shaft_length_m(*kit))});
  }
}

}  // namespace

void validate(const Machine& machine) {
  std::visit(
      overloaded{[](const JeffcottRotor& rotor) { JeffcottRotor::visit_fields(rotor, requiring("rotor.")); },
                 [](const RotorKit& kit) { validate(kit, "rotor."); }},
      machine.rotor);
  if (machine.stops.empty()) throw ConfigError("stops: at least one stop is needed");
  for (std::size_t i = 0; i < machine.stops.size(); ++i) {
    const Stop& stop = machine.stops[i];
    validate(stop, fmt::format("stops.{}.", i));
    if (const RotorKit* kit = kit_of(machine); kit != nullptr && kit->torsion && may_stick(stop.friction)) {
      throw ConfigError(fmt::format(
          "stops.{}.friction.coefficient: may stick, beside torsion of the rotor, allowed: another friction",
          i));
    }
    validate_position(machine, stop.position_m, true, fmt::format("stops.{}.position_m", i));
  }
  if (machine.kick) {
    Kick::visit_fields(*machine.kick, requiring("kick."));
    validate_position(machine, machine.kick->position_m, false, "kick.position_m");
  }
  require("gravity_m_per_s2", machine.gravity_m_per_s2, not_negative);
  if (machine.start) validate(*machine.start, machine);
}

}  // namespace rubsweep::model
