#include "explain/explain_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "explain/explain_rotor.hpp"
#include "rubsweep/core/contact/curved_law.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/hertz_line.hpp"
#include "rubsweep/core/contact/restitution.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/core/scene/constant_load.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::apps {
namespace {

double contact_half_period_s(const model::Stop& stop, double rotor_mass_kg) {
  const double mass =
      stop.casing ? contact::reduced_mass(rotor_mass_kg, stop.casing->mass_kg) : rotor_mass_kg;
  return std::numbers::pi * std::sqrt(mass / stop.stiffness_n_per_m);
}

std::string explain_casing(const model::Stop& stop, double rotor_mass_kg) {
  const double half_period_ms = 1e3 * contact_half_period_s(stop, rotor_mass_kg);
  if (!stop.casing)
    return fmt::format("  casing: rigid, no state; contact half-period {:.3g} ms\n", half_period_ms);
  const double hz = std::sqrt(stop.casing->stiffness_n_per_m / stop.casing->mass_kg) / (2 * std::numbers::pi);
  return fmt::format(
      "  casing: moves in x and y (2 coordinates), {} kg, {:.4g} Hz, damping ratio {}; contact half-period "
      "{:.3g} ms\n",
      stop.casing->mass_kg, hz, stop.casing->damping_ratio, half_period_ms);
}

/// Line on the dependence of the largest forces on rotor.modes; docs/method/rotors.md has its size.
std::string explain_fast_contact(const model::Stop& stop, double rotor_mass_kg, const model::RotorKit& kit) {
  const double contact_hz = 1 / (2 * contact_half_period_s(stop, rotor_mass_kg));
  if (contact_hz <= kit.modes_up_to_hz) return "";
  return fmt::format(
      "  contact is faster ({:.4g} Hz) than what the number of modes is chosen for ({} Hz): largest forces "
      "depend on rotor.modes\n",
      contact_hz, kit.modes_up_to_hz);
}

/// Line about a force law that is not linear, with the restitution of a free impact at this stop.
std::string explain_law(const model::Stop& stop) {
  const model::NormalLaw& law = stop.law;
  const contact::CurvedLaw curve(stop);
  std::string text = fmt::format("  force law: {}; secant at a twentieth of the clearance {:.4g} N/m\n",
                                 contact::describe(law), stop.stiffness_n_per_m);
  if (curve.factor() == 0) return text + "  contact damping: none\n";
  std::string_view damping;
  for (std::size_t i = 0; i < model::impact_dampings.values.size(); ++i)
    if (model::impact_dampings.values[i] == law.damping) damping = model::impact_dampings.texts[i];
  text += fmt::format("  contact damping: {} with restitution {}, 1 + {:.6g} p' / v0, v0 {}\n", damping,
                      law.restitution, curve.factor(),
                      law.approach_speed_m_per_s ? fmt::format("{} m/s", *law.approach_speed_m_per_s)
                                                 : "the speed of each approach");
  text += fmt::format("    a free impact with v0 returns {:.4g} of it\n",
                      contact::restitution_of_factor(curve.factor()));
  if (curve.remembers())
    text +=
        "    the motion goes by how each contact began: no proof of a period where one touches "
        "at phase 0 of a turn\n";
  return text;
}

std::string explain_damping(const model::Stop& stop, const scene::Contact& contact, double rotor_mass_kg) {
  if (!stop.law.linear()) return explain_law(stop);
  double mass = stop.contact_mass_kg.value_or(rotor_mass_kg);
  if (stop.casing) mass = contact::reduced_mass(mass, stop.casing->mass_kg);
  const double ratio = contact.damping_ns_per_m / (2 * std::sqrt(mass * stop.stiffness_n_per_m));
  std::string text = fmt::format("  force law: clamped ElastoGap, {} N/m, {:.6g} N s/m (damping ratio {:.4g}",
                                 stop.stiffness_n_per_m, contact.damping_ns_per_m, ratio);
  if (ratio < 1) {
    text += fmt::format("; a free impact returns {:.4g} of its speed", contact::delivered_restitution(ratio));
  } else {
    text += fmt::format("; beyond critical, so that a free impact returns less than {:.4g} of its speed",
                        model::DeliveredRestitution::range.low);
  }
  return text + ")\n";
}

std::string explain_friction(const model::Stop& stop, const scene::Contact& contact) {
  const double slip = contact.surface_speed_m_per_s;
  const auto name = contact::name_of(stop.friction);
  if (!contact::acts(stop.friction)) return fmt::format("  friction: {}\n", name);
  const double mu = contact::friction_coefficient(stop.friction, slip);
  if (const auto [holding, sliding] = model::holding_and_sliding(stop.friction); holding > 0) {
    const contact::Falling falling = contact::friction_terms(stop.friction).falling;
    return fmt::format(
        "  friction: dry, holds the surfaces together up to {} and slides with {}{}; reverses with the "
        "slip\n",
        holding, sliding,
        falling.steepness_s_per_m == 0 ? ""
                                       : fmt::format(", falling to it with exp(-(slip / {:.6g} m/s)^{})",
                                                     1 / falling.steepness_s_per_m, falling.exponent));
  }
  if (!contact::depends_on_slip(stop.friction)) {
    if (mu == 0) return fmt::format("  friction: {} 0\n", name);
    const bool reverses = !contact::keeps_its_direction(stop.friction);
    return fmt::format("  friction: {} {}; {}\n", name, mu,
                       reverses ? "reverses with the slip, and may hold the surfaces together"
                                : "a run whose slip would reverse says slip_reversal");
  }
  const bool saturated = contact::friction_slope(stop.friction, slip) == 0;
  return fmt::format("  friction: {}, {:.6g} at the surface speed {:.4g} m/s of the lowest speed ({})\n",
                     name, mu, slip,
                     saturated ? "saturated: there it does not depend on the slip" : "depends on the slip");
}

/// Line about the sag at a stop whose clearance counts from the position of the shaft under weight and static
/// loads.
std::string explain_sag(const scene::PreparedMachine& prepared, std::size_t stop) {
  if (!model::kit_of(prepared.machine)->clearances_from_sag) return "";
  const Eigen::Vector2d sag = scene::sag_m(prepared, stop);
  return fmt::format("  its clearance counts from the sag, {:.4g} m in x and {:.4g} m in y\n", sag.x(),
                     sag.y());
}

std::string explain_kick(const model::Machine& machine) {
  if (machine.start && !machine.start->at_rest)
    return "start: in a given state, not kicked; what is not given is that of the quiet whirl\n";
  std::string text;
  if (machine.start)
    text +=
        "start: at rest in the unloaded position, the shaft's mark along +x; unbalance and weight act from "
        "then on\n";
  if (!machine.kick) return text + "kick: none\n";
  model::for_each_kick(
      machine, [&](auto& kick, auto name) { text += fmt::format("{}: {}\n", name, scene::describe(kick)); });
  if (machine.start) return text;
  return text +
         "  none where the quiet whirl itself reaches a wall (whirl ratio 1 and above): the rotor starts at "
         "rest there\n";
}

std::string left_out(const model::Machine& machine) {
  return std::visit(
      overloaded{
          [](const model::JeffcottRotor&) {
            return "left out: torsion and drive (the speed is held constant), axial motion, tilting of "
                   "the disc\n";
          },
          [](const model::RotorKit& kit) {
            return kit.torsion ? "left out: axial motion\n"
                               : "left out: torsion and drive (the speed is held constant), axial motion\n";
          }},
      machine.rotor);
}

}  // namespace

std::string explain_stop(const scene::PreparedMachine& prepared, const scene::Cell& cell, std::size_t i,
                         const std::string& name) {
  const model::Stop& stop = prepared.machine.stops[i];
  const double mass_kg = prepared.assembly.contact_mass_kg[i];
  const scene::Contact& contact = cell.scene.contacts[i];
  std::string text =
      fmt::format("stop {}{}{}: {}, clearance {} m\n", i, model::in_brackets(name), i == 0 ? " (kicked)" : "",
                  contact::describe(stop.geometry), stop.clearance_m);
  if (model::kit_of(prepared.machine) != nullptr) {
    text += fmt::format("  at {} m of the shaft; mass behind the contact {:.4g} kg{}\n", *stop.position_m,
                        stop.contact_mass_kg.value_or(mass_kg),
                        stop.contact_mass_kg ? "" : " (modal mass of the first mode there)");
    text += explain_sag(prepared, i);
  }
  if (stop.by_hertz_secant()) {
    text += fmt::format(
        "  stiffness: secant of the Hertz line contact at {} N, half-width {:.4g} m, approach {:.4g} m\n",
        stop.hertz->design_force_n, contact::hertz_half_width_m(*stop.hertz, stop.hertz->design_force_n),
        contact::hertz_approach_m(*stop.hertz, stop.hertz->design_force_n));
  }
  text += explain_damping(stop, contact, mass_kg) + explain_friction(stop, contact) +
          explain_casing(stop, mass_kg);
  if (const model::RotorKit* kit = model::kit_of(prepared.machine))
    text += explain_fast_contact(stop, mass_kg, *kit);
  return text;
}

std::string explain_machine(const model::Machine& machine, double speed_hz,
                            const std::vector<std::string>& stop_names) {
  const scene::PreparedMachine prepared = scene::prepare_machine(structure::machine_at(machine, speed_hz));
  const scene::Cell cell = scene::build_cell(prepared, speed_hz, scene::WhirlRatio{0});
  const auto coordinates = cell.scene.structure.coordinates();
  const model::RotorKit* kit = model::kit_of(machine);
  std::string text = explain_rotor(prepared, kit != nullptr && model::has_tables(*kit));
  for (std::size_t i = 0; i < machine.stops.size(); ++i)
    text += explain_stop(prepared, cell, i, model::name_at(stop_names, i));
  text += explain_kick(machine);
  text += fmt::format("states: {} ({} coordinates and their rates)\n", 2 * coordinates, coordinates);
  text += left_out(machine);
  if (machine.gravity_m_per_s2 == 0) text += "left out: gravity (gravity_m_per_s2 is 0)\n";
  if (std::ranges::none_of(machine.stops, [](const auto& stop) { return contact::acts(stop.friction); }))
    text += "left out: friction (no stop has any)\n";
  return text;
}

}  // namespace rubsweep::apps
