#include "rubsweep/analysis/design/unbalance_response.hpp"

#include <algorithm>
#include <complex>
#include <numbers>

#include "rubsweep/core/scene/constant_load.hpp"
#include "rubsweep/core/structure/system_at.hpp"

namespace rubsweep::design {
namespace {

const structure::Point& point_of(const scene::PreparedMachine& prepared, int point) {
  return prepared.assembly.system.points[static_cast<std::size_t>(point)];
}

}  // namespace

double major_axis(const Eigen::Vector2cd& amplitude) {
  const std::complex<double> turned = std::complex<double>(0, 1) * amplitude(1);
  return std::abs(amplitude(0) + turned) + std::abs(amplitude(0) - turned);
}

std::vector<WatchedPlace> probe_places(const scene::PreparedMachine& prepared) {
  const structure::Assembly& assembly = prepared.assembly;
  if (assembly.sensor_points.empty()) {
    const model::RotorKit* kit = model::kit_of(prepared.machine);
    const auto position_m = kit != nullptr ? prepared.machine.stops.front().position_m : std::nullopt;
    return {{position_m, point_of(prepared, assembly.observed_point).map}};
  }
  const std::vector<model::Sensor>& sensors = model::kit_of(prepared.machine)->sensors;
  std::vector<WatchedPlace> places;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const bool known = std::ranges::any_of(
        places, [&](const auto& place) { return place.position_m == sensors[i].position_m; });
    if (!known) places.push_back({sensors[i].position_m, point_of(prepared, assembly.sensor_points[i]).map});
  }
  return places;
}

std::vector<WatchedPlace> stop_places(const scene::PreparedMachine& prepared) {
  const structure::Assembly& assembly = prepared.assembly;
  std::vector<WatchedPlace> places;
  for (std::size_t i = 0; i < prepared.machine.stops.size(); ++i) {
    contact::RelativeMap map = point_of(prepared, assembly.rotor_points[i]).map;
    if (assembly.casing_points[i]) map -= point_of(prepared, *assembly.casing_points[i]).map;
    places.push_back({prepared.machine.stops[i].position_m, std::move(map)});
  }
  return places;
}

scene::QuietMotion unit_response(const scene::PreparedMachine& prepared, double speed_hz) {
  const double w = 2 * std::numbers::pi * speed_hz;
  const structure::LinearSystem system = structure::system_at(prepared.assembly, w);
  return scene::quiet_motion(system, w, w * w * system.unbalance_kg, scene::constant_load_n(prepared));
}

double major_axis_at(const scene::QuietMotion& motion, const WatchedPlace& place) {
  return major_axis(place.map.cast<std::complex<double>>() * motion.amplitude);
}

}  // namespace rubsweep::design
