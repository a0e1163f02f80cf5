#include "rubsweep/sweep/idle_torsion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/contact/friction_law.hpp"

namespace rubsweep::sweep {
namespace {

/// Where KitAssembly puts the angle: behind the shapes of both planes.
double polar_inertia_kg_m2(const scene::PreparedMachine& prepared) {
  const auto& bases = prepared.reduction->bases;
  const Eigen::Index angle = bases[0].cols() + bases[1].cols();
  return prepared.assembly.system.mass(angle, angle);
}

}  // namespace

std::string why_torsion_is_idle(const scene::PreparedMachine& prepared, double slowest_hz) {
  const model::RotorKit* kit = model::kit_of(prepared.machine);
  if (kit == nullptr || !kit->torsion) return "";
  if (prepared.machine.start) return "";  // hits of any strength
  const double impulse_ns = prepared.machine.kick ? 2 / std::numbers::pi * prepared.machine.kick->force_n *
                                                        prepared.machine.kick->duration_s
                                                  : 0;
  double change_m_per_s = 0, surface_m_per_s = 0;
  for (const model::Stop& stop : prepared.machine.stops) {
    const double radius = stop.contact_radius_m, surface = 2 * std::numbers::pi * slowest_hz * radius;
    const double mu = std::abs(contact::friction_coefficient(stop.friction, surface));
    const double change = mu * 2 * impulse_ns * radius * radius / polar_inertia_kg_m2(prepared);
    const auto saturated = contact::saturated_friction(stop.friction);
    if (!saturated || !(surface - change > saturated->above_m_per_s)) return "";
    if (change < change_m_per_s) continue;
    change_m_per_s = change;
    surface_m_per_s = surface;
  }
  return fmt::format(
      "torsion: changes no force, because no friction depends on the slip where it is: a hit of twice the "
      "kick's impulse twists the surface by about {:.2g} m/s of {:.3g} m/s; without rotor.torsion the motion "
      "is the "
      "same\n",
      change_m_per_s, surface_m_per_s);
}

}  // namespace rubsweep::sweep
