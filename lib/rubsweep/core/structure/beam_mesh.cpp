#include "rubsweep/core/structure/beam_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/overloaded.hpp"

namespace rubsweep::structure {
namespace {

std::vector<double> stations_of(const model::RotorKit& kit, std::vector<double> stations) {
  double end = 0;
  stations.push_back(end);
  for (const auto& segment : kit.shaft) stations.push_back(end += segment.length_m);
  add_places(kit, stations);
  std::sort(stations.begin(), stations.end());
  const auto same = [&](double a, double b) { return b - a <= same_place * end; };
  stations.erase(std::unique(stations.begin(), stations.end(), same), stations.end());
  return stations;
}

bool coupling_at(const model::RotorKit& kit, double position_m, double tolerance_m) {
  return std::ranges::any_of(kit.couplings, [&](const auto& coupling) {
    return std::abs(coupling.position_m - position_m) <= tolerance_m;
  });
}

/// A segment and where it begins.
struct Placed {
  const model::ShaftSegment& segment;
  double begin_m;
};

Placed segment_at(const model::RotorKit& kit, double position_m) {
  double begin = 0;
  for (const auto& segment : kit.shaft) {
    const double end = begin + segment.length_m;
    if (position_m < end || &segment == &kit.shaft.back()) return {segment, begin};
    begin = end;
  }
  throw SolverError("beam shaft: there is no segment");
}

}  // namespace

void add_places(const model::RotorKit& kit, std::vector<double>& stations_m) {
  for (const auto& disc : kit.discs) stations_m.push_back(disc.position_m);
  for (const auto& support : kit.supports) {
    if (!support.at_housing) stations_m.push_back(support.position_m);
  }
  for (const auto& point : kit.point_masses) stations_m.push_back(point.position_m);
  for (const auto& coupling : kit.couplings) stations_m.push_back(coupling.position_m);
  for (const auto& load : kit.static_loads) stations_m.push_back(load.position_m);
  for (const auto& sensor : kit.sensors) stations_m.push_back(sensor.position_m);
  if (kit.bow) {
    std::visit(overloaded{[](const model::BowMode&) {},
                          [&](const model::BowPoints& points) {
                            stations_m.insert(stations_m.end(), points.position_m.begin(),
                                              points.position_m.end());
                          }},
               kit.bow->shape);
  }
}

BeamMesh mesh_of(const model::RotorKit& kit, std::vector<double> stations_m) {
  const std::vector<double> stations = stations_of(kit, std::move(stations_m));
  const double length = stations.back(), longest = length / kit.elements * (1 + same_place);
  BeamMesh mesh;
  mesh.node_position_m.push_back(stations.front());
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    const double gap = stations[i + 1] - stations[i];
    if (i > 0 && coupling_at(kit, stations[i], same_place * length)) {
      mesh.node_position_m.push_back(stations[i]);
    }
    const auto pieces = static_cast<int>(std::ceil(gap / longest));
    // No structured binding: clang 14 refuses it in a lambda.
    const Placed at = segment_at(kit, stations[i] + gap / 2);
    const auto share = [&](int k) {
      return std::clamp((stations[i] + gap * k / pieces - at.begin_m) / at.segment.length_m, 0.0, 1.0);
    };
    for (int k = 1; k <= pieces; ++k) {
      mesh.elements.push_back(
          {mesh.node_position_m.size() - 1, gap / pieces, &at.segment, share(k - 1), share(k)});
      mesh.node_position_m.push_back(k == pieces ? stations[i + 1] : stations[i] + gap * k / pieces);
    }
  }
  return mesh;
}

}  // namespace rubsweep::structure
