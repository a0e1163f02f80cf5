#include "rubsweep/core/structure/beam_element.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
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

/// A segment and the position where it begins.
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

/// Symmetric element matrix from its independent entries. The signs between deflections and angles follow
/// from exchanging the two ends of the beam.
Eigen::Matrix4d element(double ww, double ws, double ww_far, double ws_far, double ss, double ss_far) {
  Eigen::Matrix4d m;
  m << ww, ws, ww_far, ws_far,   //
      ws, ss, -ws_far, ss_far,   //
      ww_far, -ws_far, ww, -ws,  //
      ws_far, ss_far, -ws, ss;
  return m;
}

double area_m2(const model::Diameters& d) {
  return std::numbers::pi / 4 * (d.outer_m - d.inner_m) * (d.outer_m + d.inner_m);
}

double moment_m4(const model::Diameters& d) {
  return area_m2(d) / 16 * (d.outer_m * d.outer_m + d.inner_m * d.inner_m);
}

/// Ratio of shear to bending flexibility of an element.
double shear_share(const model::ShaftLayer& layer, double length_m, double at) {
  if (layer.shear_coefficient == model::ShearCoefficient::none) return 0;
  const model::Diameters stiff = model::stiffness_diameters(layer, at);
  return 12 * (layer.youngs_modulus_pa * moment_m4(stiff)) /
         (shear_coefficient(layer, at) * layer.shear_modulus_pa * area_m2(stiff) * length_m * length_m);
}

/// Matrices of translational mass, rotary inertia and stiffness of an element.
struct Energies {
  Eigen::Matrix4d translation, rotary, stiffness;
  double polar_inertia_kg_m2 = 0;
};

Energies straight_energies(const model::ShaftLayer& layer, double l) {
  const double p = shear_share(layer, l, 0), q = p * p, one = 1 + p;
  const double bending = layer.youngs_modulus_pa * moment_m4(model::stiffness_diameters(layer, 0));
  const double area = section_area_m2(layer), moment = section_moment_m4(layer);
  const double translation = layer.density_kg_per_m3 * area * l / (840 * one * one);
  const double rotation = layer.density_kg_per_m3 * moment / (30 * one * one * l);
  return {translation * element(312 + 588 * p + 280 * q, (44 + 77 * p + 35 * q) * l, 108 + 252 * p + 140 * q,
                                -(26 + 63 * p + 35 * q) * l, (8 + 14 * p + 7 * q) * l * l,
                                -(6 + 14 * p + 7 * q) * l * l),
          rotation * element(36, (3 - 15 * p) * l, -36, (3 - 15 * p) * l, (4 + 5 * p + 10 * q) * l * l,
                             (-1 - 5 * p + 5 * q) * l * l),
          bending / (one * l * l * l) * element(12, 6 * l, -12, 6 * l, (4 + p) * l * l, (2 - p) * l * l),
          2 * layer.density_kg_per_m3 * moment * l};
}

/// Shape functions of a straight element at the share t of its length: deflection, angle of the section, and
/// derivative of the angle along the element, per unit of each coordinate.
struct Shapes {
  Eigen::Vector4d deflection, angle, curvature;
};

Shapes shapes_at(double t, double p, double l) {
  const double square = t * t, cube = square * t;
  Shapes shapes;
  shapes.deflection << 1 - 3 * square + 2 * cube + p * (1 - t),
      l * (t - 2 * square + cube + p / 2 * (t - square)), 3 * square - 2 * cube + p * t,
      l * (cube - square - p / 2 * (t - square));
  shapes.angle << 6 / l * (square - t), 1 - 4 * t + 3 * square + p * (1 - t), 6 / l * (t - square),
      3 * square - 2 * t + p * t;
  shapes.curvature << 6 / l * (2 * t - 1), 6 * t - 4 - p, 6 / l * (1 - 2 * t), 6 * t - 2 + p;
  shapes.deflection /= 1 + p;
  shapes.angle /= 1 + p;
  shapes.curvature /= (1 + p) * l;
  return shapes;
}

/// Gauss points and weights on -1 to 1. Five points integrate polynomials of degree 9 exactly; deflection
/// squared times area has degree 8, as has angle squared times second moment.
constexpr std::array<std::array<double, 2>, 5> gauss{{{-0.906179845938664, 0.2369268850561891},
                                                      {-0.5384693101056831, 0.4786286704993665},
                                                      {0, 0.5688888888888889},
                                                      {0.5384693101056831, 0.4786286704993665},
                                                      {0.906179845938664, 0.2369268850561891}}};

Energies tapered_energies(const model::ShaftLayer& layer, double l, double from, double to) {
  const double middle = (from + to) / 2, p = shear_share(layer, l, middle);
  Energies sum{Eigen::Matrix4d::Zero(), Eigen::Matrix4d::Zero(), Eigen::Matrix4d::Zero(), 0};
  double area = 0;
  for (const auto& [point, weight] : gauss) {
    const double t = (1 + point) / 2, share = weight / 2 * l, at = from + (to - from) * t;
    const Shapes shapes = shapes_at(t, p, l);
    const double per_length = layer.density_kg_per_m3 * section_area_m2(layer, at);
    const double moment = section_moment_m4(layer, at);
    sum.translation += share * per_length * shapes.deflection * shapes.deflection.transpose();
    sum.rotary += share * layer.density_kg_per_m3 * moment * shapes.angle * shapes.angle.transpose();
    sum.stiffness +=
        share * layer.youngs_modulus_pa * moment * shapes.curvature * shapes.curvature.transpose();
    sum.polar_inertia_kg_m2 += 2 * share * layer.density_kg_per_m3 * moment;
    area += weight / 2 * section_area_m2(layer, at);
  }
  // The shear strain is constant along the element: p / (1 + p) times these.
  const Eigen::Vector4d strain(-1 / l, -0.5, 1 / l, -0.5);
  const double bending = layer.youngs_modulus_pa * section_moment_m4(layer, middle);
  const double rigidity = 12 * bending * p / ((1 + p) * (1 + p) * l) * area / section_area_m2(layer, middle);
  sum.stiffness += rigidity * strain * strain.transpose();
  return sum;
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

double section_area_m2(const model::ShaftLayer& layer, double at) {
  return area_m2(model::diameters(layer, at));
}

double section_moment_m4(const model::ShaftLayer& layer, double at) {
  return moment_m4(model::diameters(layer, at));
}

double shear_coefficient(const model::ShaftLayer& layer, double at) {
  const double nu = layer.youngs_modulus_pa / (2 * layer.shear_modulus_pa) - 1;
  const model::Diameters stiff = model::stiffness_diameters(layer, at);
  const double ratio = stiff.inner_m / stiff.outer_m;
  const double square = ratio * ratio, solid = (1 + square) * (1 + square);
  switch (layer.shear_coefficient) {
    case model::ShearCoefficient::cowper:
      return 6 * (1 + nu) * solid / ((7 + 6 * nu) * solid + (20 + 12 * nu) * square);
    case model::ShearCoefficient::hutchinson:
      return 6 * (1 + nu) * (1 + nu) * solid /
             ((7 + 12 * nu + 4 * nu * nu) * solid + 4 * (5 + 6 * nu + 2 * nu * nu) * square);
    case model::ShearCoefficient::none: break;
  }
  return std::numeric_limits<double>::infinity();
}

BeamElement timoshenko_element(const model::ShaftLayer& layer, double length_m, double from, double to) {
  const Energies energies = model::is_tapered(layer) ? tapered_energies(layer, length_m, from, to)
                                                     : straight_energies(layer, length_m);
  BeamElement beam;
  beam.stiffness = energies.stiffness;
  beam.mass = energies.translation;
  if (layer.rotary_inertia) beam.mass += energies.rotary;
  beam.gyroscopic = (layer.gyroscopic ? 2.0 : 0.0) * energies.rotary;
  beam.damping = layer.mass_damping_per_s * beam.mass + layer.stiffness_damping_s * beam.stiffness;
  beam.polar_inertia_kg_m2 = energies.polar_inertia_kg_m2;
  return beam;
}

BeamElement layered_element(const model::ShaftSegment& segment, double length_m, double from, double to) {
  BeamElement sum = timoshenko_element(segment, length_m, from, to);
  for (const model::ShaftLayer& layer : segment.layers) {
    const BeamElement added = timoshenko_element(layer, length_m, from, to);
    sum.mass += added.mass;
    sum.gyroscopic += added.gyroscopic;
    sum.stiffness += added.stiffness;
    sum.damping += added.damping;
    sum.polar_inertia_kg_m2 += added.polar_inertia_kg_m2;
  }
  return sum;
}

}  // namespace rubsweep::structure
