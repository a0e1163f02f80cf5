#include "rubsweep/maps/sweep/idle_torsion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/core/contact/friction_law.hpp"

namespace rubsweep::sweep {
namespace {

/// Negligible change, as a share of the speed and in radians of the unbalance's direction: the unbalance is
/// not known better than to a hundredth.
constexpr double negligible_share = 0.01;

double polar_inertia_kg_m2(const scene::PreparedMachine& prepared) {
  const Eigen::Index angle = *prepared.assembly.twist;
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
  double change_m_per_s = 0, surface_m_per_s = 0, share = 0, twist_rad = 0;
  const double torsional_rad_per_s =
      std::sqrt(kit->torsion->drive_stiffness_nm_per_rad / polar_inertia_kg_m2(prepared));
  for (const model::Stop& stop : prepared.machine.stops) {
    const double radius = stop.contact_radius_m, surface = 2 * std::numbers::pi * slowest_hz * radius;
    const double mu = std::abs(contact::friction_coefficient(stop.friction, surface));
    const double change = mu * 2 * impulse_ns * radius * radius / polar_inertia_kg_m2(prepared);
    const auto saturated = contact::saturated_friction(stop.friction);
    if (!saturated || !(surface - change > saturated->above_m_per_s)) return "";
    if (!(radius > 0)) continue;
    share = std::max(share, change / surface);
    twist_rad = std::max(twist_rad, change / radius / torsional_rad_per_s);
    if (change < change_m_per_s) continue;
    change_m_per_s = change;
    surface_m_per_s = surface;
  }
  if (share > negligible_share || twist_rad > negligible_share) return "";
  return fmt::format(
      "torsion: hardly changes the motion: no friction depends on the slip where it is, and a hit of twice "
      "the kick's impulse twists the surface by about {:.2g} m/s of {:.3g} m/s and the unbalance by {:.2g} "
      "degrees; without rotor.torsion the motion is the same but for that, and computed exactly\n",
      change_m_per_s, surface_m_per_s, twist_rad * 180 / std::numbers::pi);
}

}  // namespace rubsweep::sweep
