#include "rubsweep/core/model/machine.hpp"

#include <fmt/format.h>

#include <string>
#include <type_traits>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/require.hpp"
#include "rubsweep/core/model/shaft_end.hpp"
#include "rubsweep/core/overloaded.hpp"

namespace rubsweep::model {
namespace {

auto requiring(std::string prefix) {
  return [prefix = std::move(prefix)](const char* name, const auto& value, const auto& allowed) {
    require(prefix + name, value, allowed);
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

void validate(const StopGeometry& geometry, double clearance_m, const std::string& path) {
  std::visit(
      [&](const auto& kind) {
        std::decay_t<decltype(kind)>::visit_fields(kind, requiring(path));
        refuse(kind.problem(clearance_m), path);
      },
      geometry);
}

void validate(const Stop& stop, const std::string& path) {
  validate(stop.geometry, stop.clearance_m, path);
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
  if (machine.kick && !start.at_rest)
    throw ConfigError("start: is given beside a kick, allowed: one of the two, or rest");
  if (machine.kick && machine.kick->phase_deg)
    throw ConfigError(
        "kick.phase_deg: is given beside start: rest, where no gap is smallest, allowed: nothing");
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

Machine without_kicks(Machine machine) {
  Machine::visit_kicks(machine, [](std::string_view, auto& kick, const auto&...) { kick.reset(); });
  return machine;
}

Machine with_kick_force(Machine machine, double force_n) {
  const double first_n = machine.kick.value().force_n;
  for_each_kick(machine, [&](Kick& kick, auto) {
    kick.force_n = &kick == &*machine.kick ? force_n : first_n == 0 ? 0 : force_n * (kick.force_n / first_n);
  });
  return machine;
}

bool is_of_kick(std::string_view path) {
  bool found = false;
  const Machine any{};
  Machine::visit_kicks(any, [&](std::string_view kick, const auto&...) {
    found = found || path.substr(0, path.find('.')) == kick;
  });
  return found;
}

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
  for_each_kick(machine, [&](const Kick& kick, auto name) {
    if (!machine.kick) throw ConfigError(fmt::format("{}: is given without kick, allowed: beside it", name));
    Kick::visit_fields(kick, requiring(fmt::format("{}.", name)));
    validate_position(machine, kick.position_m, false, fmt::format("{}.position_m", name));
  });
  require("gravity_m_per_s2", machine.gravity_m_per_s2, not_negative);
  if (machine.start) validate(*machine.start, machine);
}

}  // namespace rubsweep::model
