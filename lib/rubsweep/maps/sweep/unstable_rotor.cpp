#include "rubsweep/maps/sweep/unstable_rotor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/structure/full_reference.hpp"
#include "rubsweep/core/structure/stability.hpp"

namespace rubsweep::sweep {
namespace {

constexpr std::size_t most_speeds_tried = 400, most_machines = 16;

/// Indices of at most `most` elements, spread evenly, the first and the last among them.
std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  const std::size_t taken = std::min(count, most);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < taken; ++i) places.push_back(taken == 1 ? 0 : i * (count - 1) / (taken - 1));
  return places;
}

/// Throws where the full matrices of a kit say otherwise at one of the speeds.
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
  double growth_per_s = 0, growth_hz = 0;  ///< the fastest, and the speed that it is at

  void look(const structure::Assembly& assembly, double speed_hz) {
    ++looked_at;
    const double speed = 2 * std::numbers::pi * speed_hz;
    if (!structure::grows(assembly, speed)) return;
    lowest_hz = unstable == 0 ? speed_hz : std::min(lowest_hz, speed_hz);
    highest_hz = std::max(highest_hz, speed_hz);
    ++unstable;
    const double growth = structure::growth_per_s(assembly, speed);
    if (growth <= growth_per_s) return;
    growth_per_s = growth;
    growth_hz = speed_hz;
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

/// Machine of a cell's values on the axes; empty where its numbers are not allowed together.
std::optional<scene::PreparedMachine> machine_of(const Study& study, std::size_t cell) {
  try {
    return scene::prepare_machine(study.with_keys(key_values(study.grid, cell)).machine);
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

}  // namespace

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

}  // namespace rubsweep::sweep
