#include "rubsweep/structure/beam_element.hpp"

#include <cmath>
#include <numbers>

namespace rubsweep::structure {
namespace {

/// Symmetric element matrix from its pattern: signs of the coupling of deflections and angles are those of a
/// beam turned end for end.
Eigen::Matrix4d element(double ww, double ws, double ww_far, double ws_far, double ss, double ss_far) {
  Eigen::Matrix4d m;
  m << ww, ws, ww_far, ws_far,   //
      ws, ss, -ws_far, ss_far,   //
      ww_far, -ws_far, ww, -ws,  //
      ws_far, ss_far, -ws, ss;
  return m;
}

}  // namespace

double section_area_m2(const model::ShaftSegment& segment) {
  const double outer = segment.outer_diameter_m, inner = segment.inner_diameter_m;
  return std::numbers::pi / 4 * (outer - inner) * (outer + inner);
}

double section_moment_m4(const model::ShaftSegment& segment) {
  const double outer = segment.outer_diameter_m, inner = segment.inner_diameter_m;
  return section_area_m2(segment) / 16 * (outer * outer + inner * inner);
}

double shear_coefficient(const model::ShaftSegment& segment) {
  const double nu = segment.youngs_modulus_pa / (2 * segment.shear_modulus_pa) - 1;
  const double ratio = segment.inner_diameter_m / segment.outer_diameter_m;
  const double square = ratio * ratio, solid = (1 + square) * (1 + square);
  return 6 * (1 + nu) * solid / ((7 + 6 * nu) * solid + (20 + 12 * nu) * square);
}

BeamElement timoshenko_element(const model::ShaftSegment& segment, double length_m) {
  const double l = length_m, area = section_area_m2(segment), moment = section_moment_m4(segment);
  const double bending = segment.youngs_modulus_pa * moment;
  // Ratio of shear to bending flexibility.
  const double p = 12 * bending / (shear_coefficient(segment) * segment.shear_modulus_pa * area * l * l);
  const double q = p * p, one = 1 + p;
  BeamElement beam;
  beam.stiffness =
      bending / (one * l * l * l) * element(12, 6 * l, -12, 6 * l, (4 + p) * l * l, (2 - p) * l * l);
  const double translation = segment.density_kg_per_m3 * area * l / (840 * one * one);
  beam.mass = translation * element(312 + 588 * p + 280 * q, (44 + 77 * p + 35 * q) * l,
                                    108 + 252 * p + 140 * q, -(26 + 63 * p + 35 * q) * l,
                                    (8 + 14 * p + 7 * q) * l * l, -(6 + 14 * p + 7 * q) * l * l);
  const double rotation = segment.density_kg_per_m3 * moment / (30 * one * one * l);
  const Eigen::Matrix4d rotary =
      rotation * element(36, (3 - 15 * p) * l, -36, (3 - 15 * p) * l, (4 + 5 * p + 10 * q) * l * l,
                         (-1 - 5 * p + 5 * q) * l * l);
  beam.mass += rotary;
  beam.gyroscopic = 2 * rotary;
  return beam;
}

}  // namespace rubsweep::structure
