#include "rubsweep/core/scene/build_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "rubsweep/core/contact/restitution.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/core/scene/constant_load.hpp"
#include "rubsweep/core/scene/given_start.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"
#include "rubsweep/core/structure/assembly.hpp"

namespace rubsweep::scene {
namespace {

/// Largest e >= 0 at which the convex function excursion(e) = |bow + e unbalance| reaches `target_m`; empty
/// if the function is always above it. `slope` > 0: upper bound and limit of the growth of excursion per
/// metre of e; `bow_m`: excursion(0).
std::optional<double> eccentricity_reaching(double target_m, double bow_m, double slope,
                                            const std::function<double(double)>& excursion) {
  // excursion(e) >= slope e - bow: above the target for all e > `high`.
  const double high = (target_m + bow_m) / slope;
  if (high == 0) return 0;
  const auto excess = [&](double e) { return excursion(e) - target_m; };
  double low = 0;
  if (bow_m > target_m) {
    low = boost::math::tools::brent_find_minima(excess, 0.0, high, 40).first;
    if (excess(low) > 0) return std::nullopt;
  }
  if (excess(high) <= 0) return high;
  std::uintmax_t iterations = 400;  // four of them at least halve the bracket
  const auto bracket = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
}

double damping_of(const model::Stop& stop, double rotor_mass_kg) {
  const double rotor_kg = stop.contact_mass_kg.value_or(rotor_mass_kg);
  const double reduced_kg = stop.casing ? contact::reduced_mass(rotor_kg, stop.casing->mass_kg) : rotor_kg;
  const auto constant = [&](double ratio, double mass_kg) {
    return contact::damping_constant(ratio, mass_kg, stop.stiffness_n_per_m);
  };
  return std::visit(overloaded{[&](const model::NominalRestitution& nominal) {
                                 return constant(contact::nominal_damping_ratio(nominal.value), reduced_kg);
                               },
                               [&](const model::DeliveredRestitution& delivered) {
                                 return constant(contact::damping_ratio_delivering(delivered.value),
                                                 reduced_kg);
                               },
                               [](const model::ExplicitDamping& given) { return given.damping_ns_per_m; },
                               [&](const model::RestitutionByRotorMass& printed) {
                                 return constant(contact::nominal_damping_ratio(printed.value), rotor_kg);
                               }},
                    stop.damping);
}

Contact contact_of(const model::Stop& stop, const structure::Assembly& assembly, std::size_t index,
                   double speed_rad_per_s) {
  Contact contact;
  contact.rotor_point = assembly.rotor_points[index];
  contact.casing_point = assembly.casing_points[index];
  contact.wall = contact::wall_of(stop.geometry);
  contact.clearance_m = stop.clearance_m;
  if (stop.law.linear()) {
    contact.stiffness_n_per_m = stop.stiffness_n_per_m;
    contact.damping_ns_per_m = damping_of(stop, assembly.contact_mass_kg[index]);
  } else {
    contact.stiffness_n_per_m = contact::secant_n_per_m(stop);
    contact.law = std::make_shared<contact::CurvedLaw>(stop);
  }
  contact.friction = stop.friction;
  contact.surface_speed_m_per_s = stop.contact_radius_m * speed_rad_per_s;
  return contact;
}

/// Adds the kicks of the machine to the scene. `wall`: direction of a kick that has none.
void add_kicks(Scene& scene, const PreparedMachine& prepared, const Eigen::Vector2d& wall) {
  const structure::Assembly& assembly = prepared.assembly;
  model::for_each_kick(prepared.machine, [&](const model::Kick& kick, auto) {
    // Every member has a name here, so that a further one does not compile. The phase belongs to t = 0.
    const auto& [force_n, duration_s, angle_deg, position_m, phase_deg] = kick;
    // A Jeffcott rotor has one point.
    const std::size_t further = model::kit_of(prepared.machine) ? scene.pulses.size() : 0,
                      point = static_cast<std::size_t>(assembly.kick_point) + further;
    const Eigen::Vector2d towards = angle_deg ? contact::direction(*angle_deg) : wall;
    scene.pulses.push_back({assembly.system.points[point].map.transpose() * towards, force_n, duration_s});
  });
}

/// Sets both measures of the unbalance, each as computed from the other. Where they are not `related`, the
/// measure that is not given becomes NaN.
void set_measures(Cell& cell, const Unbalance& unbalance, bool related, const auto& eccentricity_of,
                  const auto& whirl_ratio_of) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::visit(overloaded{[&](const WhirlRatio& ratio) {
                          cell.whirl_ratio = ratio.value;
                          cell.eccentricity_m = related ? eccentricity_of(ratio.value) : none;
                        },
                        [&](const Eccentricity& eccentricity) {
                          cell.eccentricity_m = eccentricity.value_m;
                          cell.whirl_ratio = related ? whirl_ratio_of(eccentricity.value_m) : none;
                        }},
             unbalance);
}

/// Sets both measures of an unbalance that acts alone. `remaining_m`: clearance that static forces leave at
/// the first stop. The measures are unrelated where this is not positive, or the amplitude is unbounded.
void set_unbalance(Cell& cell, const Unbalance& unbalance, double remaining_m, double amplitude_per_m) {
  set_measures(
      cell, unbalance, remaining_m > 0 && std::isfinite(amplitude_per_m),
      [&](double ratio) { return ratio * remaining_m / amplitude_per_m; },
      [&](double eccentricity_m) { return eccentricity_m * amplitude_per_m / remaining_m; });
}

/// The same for an unbalance that acts together with a bow or with forces at twice the speed.
void set_unbalance_on_bow(Cell& cell, const Unbalance& unbalance, double remaining_m, const QuietMotion& bow,
                          const QuietMotion& unit) {
  const structure::LinearSystem& structure = cell.scene.structure;
  const Contact& contact = cell.scene.contacts.front();
  const auto excursion = [&](double e) {
    return quiet_penetration({bow.mean, bow.amplitude + e * unit.amplitude, bow.second_amplitude}, structure,
                             contact)
        .amplitude;
  };
  const double slope = quiet_penetration(unit, structure, contact).amplitude;
  const auto eccentricity_of = [&](double ratio) {
    return eccentricity_reaching(ratio * remaining_m, excursion(0), slope, excursion)
        .value_or(std::numeric_limits<double>::quiet_NaN());
  };
  set_measures(
      cell, unbalance, remaining_m > 0 && std::isfinite(slope) && slope > 0 && std::isfinite(excursion(0)),
      eccentricity_of, [&](double eccentricity_m) { return excursion(eccentricity_m) / remaining_m; });
}

/// Smallest share in (0, 1] of the displacement to the static position at which the rotor meets a wall; 1 if
/// it meets none.
double share_before_contact(const Cell& cell) {
  double share = 1;
  for (const Contact& contact : cell.scene.contacts) {
    const Eigen::Vector2d way = relative_map(cell.scene.structure, contact) * cell.quiet.mean;
    share = std::min(share, contact::share_of_way_to(contact.wall, contact.clearance_m, way));
  }
  return share;
}

void start_at_rest(Cell& cell) {
  cell.start = Start::contact;
  cell.scene.pulses.clear();
  cell.scene.displacement_m = share_before_contact(cell) * cell.quiet.mean;
  cell.scene.velocity_m_per_s = Eigen::VectorXd::Zero(cell.quiet.mean.size());
}

/// At the first stop the whirl ratio decides, so that rounding has no effect at a ratio of exactly 1.
bool touches_anywhere(const Cell& cell) {
  if (!(cell.whirl_ratio < 1)) return true;
  for (const Contact& contact : cell.scene.contacts) {
    const auto [mean, amplitude] = quiet_penetration(cell.quiet, cell.scene.structure, contact);
    if (mean + amplitude >= 0) return true;
  }
  return false;
}

/// Structure, walls and constant force at a speed, which do not depend on unbalance and kick.
Scene scene_at(const PreparedMachine& prepared, double speed_hz) {
  const structure::Assembly& assembly = prepared.assembly;
  if (!assembly.tables.empty()) structure::refuse_beyond_tables(prepared.machine, speed_hz, speed_hz);
  Scene scene;
  scene.speed_rad_per_s = 2 * std::numbers::pi * speed_hz;
  for (std::size_t i = 0; i < prepared.machine.stops.size(); ++i)
    scene.contacts.push_back(contact_of(prepared.machine.stops[i], assembly, i, scene.speed_rad_per_s));
  scene.constant_n = constant_load_n(prepared);
  scene.observed_point = assembly.observed_point;
  scene.length_scale_m = scene.contacts.front().clearance_m;
  scene.structure = structure::system_at(assembly, scene.speed_rad_per_s);
  scene.impulses = assembly.impulses;
  return scene;
}

/// If one measure of the unbalance overflows, sets it to NaN, because the other cannot be computed from it.
void forget_what_overflows(Cell& cell) {
  for (double* said : {&cell.whirl_ratio, &cell.eccentricity_m}) {
    if (!std::isfinite(*said)) *said = std::numeric_limits<double>::quiet_NaN();
  }
}

/// Phase factor of the kick's delay: the angle by which the shaft turns from the smallest gap to the kick.
std::complex<double> phase_of_kick(const model::Machine& machine) {
  const double phase_deg = machine.kick ? machine.kick->phase_deg.value_or(0) : 0;
  // Without a phase, the factor is exactly 1, so that the motion does not change by a bit.
  return phase_deg == 0 ? 1.0 : std::polar(1.0, phase_deg * std::numbers::pi / 180);
}

/// Torsion of the scene; the unbalance has the phase of the cell.
Twist twist_of(const PreparedMachine& prepared, double eccentricity_m, std::complex<double> phase) {
  const structure::Assembly& assembly = prepared.assembly;
  Twist twist;
  twist.coordinate = *assembly.twist;
  twist.unbalance_kg_m = eccentricity_m * phase * assembly.system.unbalance_kg;
  twist.bow_n = phase * assembly.bow_n;
  twist.gyroscopic = assembly.gyroscopic;
  twist.circulatory = assembly.circulatory;
  twist.unbalance_inertia_kg_m2 = eccentricity_m * eccentricity_m * assembly.unbalance_inertia_kg;
  for (const model::Stop& stop : prepared.machine.stops)
    twist.contact_radius_m.push_back(stop.contact_radius_m);
  return twist;
}

void start_on_quiet_motion(Cell& cell, bool from_rest) {
  Scene& scene = cell.scene;
  const double w = scene.speed_rad_per_s;
  cell.quiet = quiet_motion(scene.structure, w, scene.harmonic_n, scene.constant_n, scene.second_harmonic_n);
  scene.displacement_m = cell.quiet.displacement(0);
  scene.velocity_m_per_s = w * cell.quiet.velocity(0);
  if (!from_rest && touches_anywhere(cell)) start_at_rest(cell);
}

}  // namespace

std::string describe(const model::Kick& kick) {
  const auto& [force_n, duration_s, angle_deg, position_m, phase_deg] = kick;
  return fmt::format("half-sine, {} N for {} s{}{}", force_n, duration_s,
                     angle_deg ? fmt::format(" at {} degrees", *angle_deg) : "",
                     phase_deg ? fmt::format(", {} degrees after the smallest gap", *phase_deg) : "");
}

Cell build_cell(const PreparedMachine& prepared, double speed_hz, const Unbalance& unbalance) {
  const structure::Assembly& assembly = prepared.assembly;
  Cell cell;
  cell.scene = scene_at(prepared, speed_hz);
  Scene& scene = cell.scene;
  const Contact& first = scene.contacts.front();
  const double w = scene.speed_rad_per_s;
  const Eigen::VectorXcd unit_force = w * w * scene.structure.unbalance_kg;
  const QuietMotion unit = quiet_motion(scene.structure, w, unit_force, scene.constant_n);
  const auto [mean, amplitude_per_m] = quiet_penetration(unit, scene.structure, first);
  const Eigen::Vector2d wall = nearest_wall(unit, scene.structure, first);
  add_kicks(scene, prepared, wall);
  const bool bowed = assembly.bow_n.size() > 0 || assembly.second_n.size() > 0;
  const Eigen::VectorXcd bow_n =
      assembly.bow_n.size() > 0 ? assembly.bow_n : Eigen::VectorXcd(0 * unit_force);
  QuietMotion bow;
  if (bowed) {
    bow = quiet_motion(scene.structure, w, bow_n, scene.constant_n, assembly.second_n);
    set_unbalance_on_bow(cell, unbalance, -mean, bow, unit);
  } else {
    set_unbalance(cell, unbalance, -mean, amplitude_per_m);
  }
  forget_what_overflows(cell);
  const bool has_quiet_motion = std::isfinite(amplitude_per_m) && std::isfinite(mean);
  // A run from rest needs no quiet motion: at an undamped resonance it grows until it meets a wall.
  const bool needs_none = model::begins_at_rest(prepared.machine.start) && std::isfinite(mean);
  if (!(has_quiet_motion || needs_none) || !std::isfinite(cell.eccentricity_m)) {
    cell.start = has_quiet_motion && mean >= 0 ? Start::initial_contact : Start::unreachable;
    return cell;
  }
  if (bowed) bow.amplitude += cell.eccentricity_m * unit.amplitude;
  const std::complex<double> phase =
      model::begins_at_rest(prepared.machine.start)
          ? 1
          : phase_to_smallest_gap(bowed ? bow : unit, scene.structure, first, wall);
  if (bowed) {
    scene.harmonic_n = phase * (bow_n + cell.eccentricity_m * unit_force);
    scene.second_harmonic_n = phase * phase * assembly.second_n;
  } else {
    scene.harmonic_n = cell.eccentricity_m * phase * unit_force;
  }
  if (assembly.twist)
    scene.twist = twist_of(prepared, cell.eccentricity_m, phase * phase_of_kick(prepared.machine));
  scene.harmonic_n *= phase_of_kick(prepared.machine);
  scene.second_harmonic_n *= phase_of_kick(prepared.machine) * phase_of_kick(prepared.machine);
  start_on_quiet_motion(cell, model::begins_at_rest(prepared.machine.start));
  start_in_given_state(scene, prepared);
  return cell;
}

Cell build_cell(const model::Machine& machine, double speed_hz, const Unbalance& unbalance) {
  return build_cell(prepare_machine(structure::machine_at(machine, speed_hz)), speed_hz, unbalance);
}

}  // namespace rubsweep::scene
