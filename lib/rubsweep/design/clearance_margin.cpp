#include "rubsweep/design/clearance_margin.hpp"

#include <algorithm>
#include <limits>

#include "rubsweep/design/largest_over_speed.hpp"
#include "rubsweep/design/unbalance_response.hpp"

namespace rubsweep::design {
namespace {

/// Twice the gap that the mean position leaves at a stop, not below 0.
double diametral_clearance_m(const scene::PreparedMachine& prepared, std::size_t stop,
                             const WatchedPlace& place, const scene::QuietMotion& motion) {
  const model::Stop& described = prepared.machine.stops[stop];
  const contact::Excursion about = contact::excursion(
      contact::wall_of(described.geometry), described.clearance_m, place.map, motion.mean, motion.amplitude);
  return std::max(0.0, -2 * about.mean);
}

}  // namespace

std::vector<ClearanceMargin> clearance_margins(const scene::PreparedMachine& prepared, double eccentricity_m,
                                               std::span<const double> speeds_hz) {
  const std::vector<WatchedPlace> places = stop_places(prepared);
  std::vector<ClearanceMargin> margins;
  for (std::size_t stop = 0; stop < places.size(); ++stop) {
    const auto at = [&](double speed_hz) {
      const scene::QuietMotion motion = unit_response(prepared, speed_hz);
      ClearanceMargin found{stop, places[stop].position_m, speed_hz, 0, 0, 0};
      found.major_axis_m = eccentricity_m * major_axis_at(motion, places[stop]);
      found.diametral_clearance_m = diametral_clearance_m(prepared, stop, places[stop], motion);
      found.margin = found.diametral_clearance_m > 0
                         ? 1 - found.major_axis_m / (clearance_share * found.diametral_clearance_m)
                         : -std::numeric_limits<double>::infinity();
      return found;
    };
    margins.push_back(at(largest_over_speed(speeds_hz, [&](double hz) { return -at(hz).margin; }).speed_hz));
  }
  return margins;
}

}  // namespace rubsweep::design
