#include "rubsweep/core/model/shaft_segment.hpp"

#include <numbers>

namespace rubsweep::model {
namespace {

double between(double begin, const std::optional<double>& end, double at) {
  return end ? begin + (*end - begin) * at : begin;
}

double squares_m2(const ShaftLayer& layer, double at) {
  const Diameters d = diameters(layer, at);
  return d.outer_m * d.outer_m - d.inner_m * d.inner_m;
}

double layer_mass_kg(const ShaftLayer& layer, double length_m) {
  // Squares of diameters are quadratic along a taper, which Simpson's rule integrates exactly.
  const double mean_m2 = is_tapered(layer)
                             ? (squares_m2(layer, 0) + 4 * squares_m2(layer, 0.5) + squares_m2(layer, 1)) / 6
                             : squares_m2(layer, 0);
  return layer.density_kg_per_m3 * length_m * std::numbers::pi / 4 * mean_m2;
}

}  // namespace

Diameters diameters(const ShaftLayer& layer, double at) {
  return {between(layer.outer_diameter_m, layer.outer_diameter_end_m, at),
          between(layer.inner_diameter_m, layer.inner_diameter_end_m, at)};
}

Diameters stiffness_diameters(const ShaftLayer& layer, double at) {
  const Diameters d = diameters(layer, at);
  return {layer.stiffness_outer_diameter_m.value_or(d.outer_m),
          layer.stiffness_inner_diameter_m.value_or(d.inner_m)};
}

bool is_tapered(const ShaftLayer& layer) { return layer.outer_diameter_end_m || layer.inner_diameter_end_m; }

double mass_kg(const ShaftSegment& segment) {
  double mass = layer_mass_kg(segment, segment.length_m);
  for (const ShaftLayer& layer : segment.layers) mass += layer_mass_kg(layer, segment.length_m);
  return mass;
}

std::optional<PartProblem> diameter_problem(const ShaftLayer& layer) {
  constexpr const char* no_wall = "no wall is left";
  const Diameters begin = diameters(layer, 0), end = diameters(layer, 1);
  if (begin.inner_m >= begin.outer_m)
    return PartProblem{"inner_diameter_m", no_wall, "a number below outer_diameter_m"};
  if (end.inner_m >= end.outer_m) {
    return PartProblem{layer.inner_diameter_end_m ? "inner_diameter_end_m" : "outer_diameter_end_m", no_wall,
                       "an inner diameter below the outer one at the end of the segment, too"};
  }
  const bool apart = layer.stiffness_outer_diameter_m || layer.stiffness_inner_diameter_m;
  const char* key =
      layer.stiffness_inner_diameter_m ? "stiffness_inner_diameter_m" : "stiffness_outer_diameter_m";
  if (apart && is_tapered(layer))
    return PartProblem{key, "given for a taper", "stiffness diameters of a straight segment"};
  const Diameters stiff = stiffness_diameters(layer, 0);
  if (stiff.inner_m >= stiff.outer_m)
    return PartProblem{key, no_wall, "an inner diameter that bends below the outer one"};
  return std::nullopt;
}

}  // namespace rubsweep::model
