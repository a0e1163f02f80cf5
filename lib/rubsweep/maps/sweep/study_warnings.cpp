#include "rubsweep/maps/sweep/study_warnings.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <vector>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/response/proof/rest_proof.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/structure/full_reference.hpp"
#include "rubsweep/core/structure/stability.hpp"

namespace rubsweep::sweep {
namespace {

constexpr std::size_t most_speeds = 100;

/// Quiet cell nearest to the wall at one speed; empty where all cells touch without a kick. `descending`: all
/// unbalances, the largest first.
std::optional<scene::Cell> nearest_quiet_cell(const Study& study, const scene::PreparedMachine& prepared,
                                              double speed_hz, const std::vector<double>& descending) {
  for (const double unbalance : descending) {
    scene::Cell cell = scene::build_cell(prepared, speed_hz, unbalance_of(study.grid, unbalance));
    if (cell.start == scene::Start::quiet) return cell;
  }
  return std::nullopt;
}

/// Whether the kick surely cannot bring the rotor to a wall. A pulse of any length changes a modal amplitude
/// by no more than its whole impulse would in an instant. Returns false for several pulses, since their
/// bounds do not simply add up.
bool never_touches(const scene::Cell& cell, numerics::ModalFormCache& forms) {
  const scene::Scene& scene = cell.scene;
  if (scene.pulses.size() > 1) return false;
  std::vector<double> section = integrate::run::scaled_initial_state(scene);
  for (const scene::Pulse& pulse : scene.pulses) {
    const double impulse_ns = 2 / std::numbers::pi * pulse.force_n * pulse.duration_s;
    const Eigen::VectorXd jump = scene.structure.mass.llt().solve(impulse_ns * pulse.direction) /
                                 integrate::run::state_scale(scene).unit_velocity_m_per_s();
    const auto n = static_cast<std::size_t>(jump.size());
    for (std::size_t i = 0; i < n; ++i) section[n + i] += jump(static_cast<Eigen::Index>(i));
  }
  return response::proof::RestProof(cell, forms).proves(section);
}

/// Reason why no cell touches; empty if some cell may. `forms`: cache of modal forms, the same for all kicks.
std::string why_untouched(const Study& study, const scene::PreparedMachine& prepared,
                          numerics::ModalFormCache& forms) {
  if (!study.grid.axes.empty()) return "";  // the machine differs from cell to cell
  if (study.machine.start) return "";
  std::vector<double> descending = study.grid.unbalance;
  std::sort(descending.begin(), descending.end(), std::greater<>());
  const std::vector<double>& speeds = study.grid.speed_hz;
  const std::size_t looked_at = std::min(speeds.size(), most_speeds);
  bool any = false;
  for (std::size_t i = 0; i < looked_at; ++i) {
    const double speed_hz = speeds[i * speeds.size() / looked_at];
    const auto cell = nearest_quiet_cell(study, prepared, speed_hz, descending);
    if (!cell) continue;
    if (!never_touches(*cell, forms)) return "";
    any = true;
  }
  if (!any) return "";
  const auto& kick = prepared.machine.kick;
  if (!kick) {
    return "no kick: the cells whose quiet whirl leaves a clearance (whirl ratio below 1) touch nothing and "
           "are all non_contact; to change that, give kick.force_n and kick.duration_s\n";
  }
  return fmt::format(
      "weak kick: {} N for {} s reach no wall from any cell whose quiet whirl leaves a clearance (whirl "
      "ratio below 1), which are all non_contact; to change that, raise kick.force_n\n",
      kick->force_n, kick->duration_s);
}

/// Negligible change, as a share of the speed, and in radians for the direction of the unbalance, which is
/// not known more accurately than to a hundredth.
constexpr double negligible_share = 0.01;

double polar_inertia_kg_m2(const scene::PreparedMachine& prepared) {
  const Eigen::Index angle = *prepared.assembly.twist;
  return prepared.assembly.system.mass(angle, angle);
}

constexpr std::size_t most_speeds_tried = 400, most_machines = 16;

/// Indices of at most `most` elements, spread evenly, including the first and the last.
std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  const std::size_t taken = std::min(count, most);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < taken; ++i) places.push_back(taken == 1 ? 0 : i * (count - 1) / (taken - 1));
  return places;
}

/// Throws ConfigError where full and reduced matrices of a kit disagree on stability at one of the speeds.
void refuse_mistaken(const scene::PreparedMachine& prepared, const std::set<double>& speeds_hz) {
  const model::RotorKit* kit = model::kit_of(prepared.machine);
  if (kit == nullptr) return;
  std::vector<double> stops_m;
  for (const model::Stop& stop : prepared.machine.stops) stops_m.push_back(*stop.position_m);
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(*kit, stops_m);
  for (const double hz : speeds_hz) {
    if (!structure::growth_is_mistaken(shaft, *kit, prepared.assembly, 2 * std::numbers::pi * hz)) continue;
    throw ConfigError(fmt::format(
        "rotor.modes: at {} a free vibration grows by the full matrices and none by the modes that are kept, "
        "or the other way round, allowed: more modes, or a higher rotor.modes_up_to_hz",
        model::speed_text(hz)));
  }
}

struct Found {
  std::size_t looked_at = 0, unstable = 0;
  double lowest_hz = 0, highest_hz = 0;
  double growth_per_s = 0, growth_hz = 0;  ///< fastest growth, and speed at which it occurs

  void look(const structure::Assembly& assembly, double speed_hz) {
    const double speed = 2 * std::numbers::pi * speed_hz;
    Found one{.looked_at = 1};
    if (structure::grows(assembly, speed))
      one = {1, 1, speed_hz, speed_hz, structure::growth_per_s(assembly, speed), speed_hz};
    add(one);
  }

  void add(const Found& other) {
    looked_at += other.looked_at;
    if (other.unstable == 0) return;
    lowest_hz = unstable == 0 ? other.lowest_hz : std::min(lowest_hz, other.lowest_hz);
    highest_hz = std::max(highest_hz, other.highest_hz);
    unstable += other.unstable;
    if (other.growth_per_s <= growth_per_s) return;
    growth_per_s = other.growth_per_s;
    growth_hz = other.growth_hz;
  }
};

/// Machine for the values of a cell on the axes; empty where its numbers are not allowed together.
std::optional<scene::PreparedMachine> machine_of(const Study& study, std::size_t cell) {
  try {
    return scene::prepare_machine(study.with_keys(key_values(study.grid, cell)).machine);
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

}  // namespace

std::string why_walls_stay_untouched(const Study& study, const scene::PreparedMachine& prepared) {
  numerics::ModalFormCache forms;
  return why_untouched(study, prepared, forms);
}

std::optional<double> least_kick_force_n(const Study& study, const scene::PreparedMachine& prepared) {
  const auto& kick = prepared.machine.kick;
  numerics::ModalFormCache forms(std::size_t{256} << 20);
  if (!kick || kick->force_n == 0 || why_untouched(study, prepared, forms).empty()) return std::nullopt;
  const auto may_touch = [&](double force_n) {
    const model::Machine machine = model::with_kick_force(prepared.machine, force_n);
    return why_untouched(study, scene::prepare_other_kick(prepared, machine), forms).empty();
  };
  constexpr double most = 1e9, within = 1.01;
  double below_n = kick->force_n, above_n = 2 * below_n;
  while (!may_touch(above_n)) {
    if (above_n > most * kick->force_n) return std::nullopt;
    below_n = above_n;
    above_n *= 2;
  }
  while (above_n > within * below_n) {
    const double middle_n = std::sqrt(below_n * above_n);
    (may_touch(middle_n) ? above_n : below_n) = middle_n;
  }
  return above_n;
}

std::string why_torsion_is_idle(const scene::PreparedMachine& prepared, double slowest_hz) {
  const model::RotorKit* kit = model::kit_of(prepared.machine);
  if (kit == nullptr || !kit->torsion) return "";
  if (prepared.machine.start) return "";  // a given state may cause hits of any strength
  double impulse_ns = 0;
  model::for_each_kick(prepared.machine, [&](const model::Kick& kick, auto) {
    impulse_ns += 2 / std::numbers::pi * kick.force_n * kick.duration_s;
  });
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

std::string where_rotor_is_unstable(const Study& study, const scene::PreparedMachine& prepared) {
  const std::vector<double>& speeds = study.grid.speed_hz;
  const std::vector<std::size_t> places = spread(speeds.size(), most_speeds_tried);
  Found found;
  const auto look = [&](const scene::PreparedMachine& machine) {
    Found here;
    for (const std::size_t place : places) here.look(machine.assembly, speeds[place]);
    refuse_mistaken(machine, {speeds.front(), here.unstable > 0 ? here.growth_hz : speeds[speeds.size() / 2],
                              speeds.back()});
    found.add(here);
  };
  if (study.grid.axes.empty()) {
    look(prepared);
  } else {
    const std::size_t in_plane = speeds.size() * study.grid.unbalance.size();
    for (const std::size_t plane : spread(cell_count(study.grid) / in_plane, most_machines))
      if (const auto machine = machine_of(study, plane * in_plane)) look(*machine);
  }
  if (found.unstable == 0) return "";
  return fmt::format(
      "unstable rotor: at {} of {} speeds looked at, from {}, a free vibration of the rotor "
      "without its stops grows (by {:.3g} 1/s at {}): the quiet whirl does not last, kicked or not, "
      "and nothing but the stops limits the motion; rows say {}, rubtrace --campbell shows the modes\n",
      found.unstable, found.looked_at, model::speed_range_text(found.lowest_hz, found.highest_hz),
      found.growth_per_s, model::speed_text(found.growth_hz), unstable_rotor);
}

std::string describe_many_modes(const scene::PreparedMachine& prepared) {
  // With more modes every step of the exact solver becomes slower.
  constexpr std::size_t many = 12;
  const model::RotorKit* kit = model::kit_of(prepared.machine);
  if (kit == nullptr || !prepared.reduction || !prepared.reduction->automatic) return "";
  const auto& numbers = prepared.reduction->mode_number;
  const std::size_t most = std::max(numbers[0].size(), numbers[1].size());
  if (most <= many) return "";
  return fmt::format(
      "modes: auto keeps {} modes a plane, and a cell takes longer with each; a smaller rotor.modes_up_to_hz "
      "(now {}) or a number as rotor.modes keeps fewer",
      most, kit->modes_up_to_hz);
}

}  // namespace rubsweep::sweep
