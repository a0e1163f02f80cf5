#include "rubsweep/analysis/design/unbalance_response.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "rubsweep/core/scene/constant_load.hpp"
#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::design {
namespace {

const structure::Point& point_of(const scene::PreparedMachine& prepared, int point) {
  return prepared.assembly.system.points[static_cast<std::size_t>(point)];
}

}  // namespace

std::vector<double> response_speeds(const SpeedRange& range,
                                    std::span<const linear::CriticalSpeed> critical) {
  constexpr int even = 401;
  std::vector<double> speeds = batch::evenly_spaced(range.from_hz, range.to_hz, even);
  for (const linear::CriticalSpeed& one : critical) {
    const double half_width_hz = std::abs(one.damping_ratio) * one.speed_hz;
    for (const double widths : {-8.0, -4.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0, 8.0}) {
      const double speed_hz = one.speed_hz + widths * half_width_hz;
      if (range.contains(speed_hz)) speeds.push_back(speed_hz);
    }
  }
  std::ranges::sort(speeds);
  speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
  return speeds;
}

std::vector<double> within(const SpeedRange& range, std::span<const double> speeds_hz) {
  std::vector<double> inside{range.from_hz};
  for (const double speed_hz : speeds_hz)
    if (speed_hz > range.from_hz && speed_hz < range.to_hz) inside.push_back(speed_hz);
  inside.push_back(range.to_hz);
  return inside;
}

Largest largest_over_speed(std::span<const double> speeds_hz, const std::function<double(double)>& value) {
  constexpr int bits = 40;
  const auto negative = [&](double speed_hz) {
    const double found = value(speed_hz);
    return std::isfinite(found) ? -found : -std::numeric_limits<double>::infinity();
  };
  std::vector<double> samples;
  for (const double speed_hz : speeds_hz) samples.push_back(-negative(speed_hz));
  Largest largest{speeds_hz.front(), samples.front()};
  const auto consider = [&](double speed_hz, double found) {
    if (found > largest.value) largest = {speed_hz, found};
  };
  for (std::size_t k = 0; k < samples.size(); ++k) {
    consider(speeds_hz[k], samples[k]);
    // A peak may also stand between an end and the sample beside it.
    const std::size_t before = k > 0 ? k - 1 : k, behind = std::min(k + 1, samples.size() - 1);
    if (before == behind || samples[k] < samples[before] || samples[k] < samples[behind] ||
        std::isinf(samples[k]))
      continue;
    std::uintmax_t iterations = 100;
    const auto [speed_hz, least] = boost::math::tools::brent_find_minima(negative, speeds_hz[before],
                                                                         speeds_hz[behind], bits, iterations);
    consider(speed_hz, -least);
  }
  return largest;
}

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
    auto place = std::ranges::find(places, sensors[i].position_m, &WatchedPlace::position_m);
    if (place == places.end())
      place =
          places.insert(place, {sensors[i].position_m, point_of(prepared, assembly.sensor_points[i]).map});
    place->name += (place->name.empty() || sensors[i].name.empty() ? "" : ", ") + sensors[i].name;
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

}  // namespace rubsweep::design
