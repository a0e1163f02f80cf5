#include "rubsweep/core/model/balance.hpp"

#include <cmath>
#include <numbers>

#include "rubsweep/core/model/shaft_matrices.hpp"

namespace rubsweep::model {

double unbalanced_mass_kg(const Machine& machine) {
  const RotorKit* kit = kit_of(machine);
  if (kit == nullptr) return std::get<JeffcottRotor>(machine.rotor).mass_kg;
  if (kit->matrices) return unbalanced_mass_kg(*kit->matrices);
  double mass_kg = 0;
  for (const Disc& disc : kit->discs) mass_kg += disc.mass_kg * std::abs(disc.eccentricity_ratio);
  return mass_kg;
}

double rotor_mass_kg(const Machine& machine) {
  const RotorKit* kit = kit_of(machine);
  if (kit == nullptr) return std::get<JeffcottRotor>(machine.rotor).mass_kg;
  if (kit->matrices) return rotor_mass_kg(*kit->matrices);
  double mass_kg = 0;
  for (const Disc& disc : kit->discs) mass_kg += disc.mass_kg;
  for (const ShaftSegment& part : kit->shaft) mass_kg += model::mass_kg(part);
  for (const PointMass& point : kit->point_masses) mass_kg += point.mass_kg;
  return mass_kg;
}

double g_mm_per_metre(const Machine& machine) { return 1e6 * unbalanced_mass_kg(machine); }

double grade_per_metre(const Machine& machine, double rated_speed_hz) {
  const double share = kit_of(machine) == nullptr ? 1 : unbalanced_mass_kg(machine) / rotor_mass_kg(machine);
  return 1e3 * 2 * std::numbers::pi * rated_speed_hz * share;
}

}  // namespace rubsweep::model
