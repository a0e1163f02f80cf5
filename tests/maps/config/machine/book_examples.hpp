#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/structure/hand_matrices.hpp"
#include "core/structure/steel.hpp"
#include "maps/config/machine/ross_text.hpp"

namespace rubsweep::config::machine {

/// A rotor of Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines (2010): a steel shaft of 1.5 m
/// length and 50 mm diameter in six elements, with steel discs of 70 mm width.
struct BookExample {
  struct Disc {
    int node;
    double diameter_m;

    static constexpr double width_m = 0.07, hole_m = 0.05;
    double mass_kg() const {
      return 7810 * width_m * std::numbers::pi / 4 * (diameter_m * diameter_m - hole_m * hole_m);
    }
    double polar_kg_m2() const {
      return std::numbers::pi / 32 * (std::pow(diameter_m, 4) - std::pow(hole_m, 4)) * 7810 * width_m;
    }
    double diametral_kg_m2() const { return polar_kg_m2() / 2 + mass_kg() * width_m * width_m / 12; }
  };
  struct Bearing {
    int node;
    double x_n_per_m, y_n_per_m;
  };

  std::string number;
  std::vector<Disc> discs;
  std::vector<Bearing> bearings;
  /// Lowest whirl frequencies as printed, at rest and at 4000 rpm, and their relative accuracy.
  std::vector<double> at_rest_rad_per_s, turning_rad_per_s;
  double printed_within = 0;
};

inline constexpr double book_element_m = 0.25;

/// Examples of the book. Printed frequencies come from ROSS for 5.9.1 (docs/examples/example_05_09_01.rst),
/// else from the book.
inline std::vector<BookExample> book_examples() {
  const std::vector<BookExample::Disc> two{{2, 0.28}, {4, 0.35}};
  return {{"5.9.1",
           two,
           {{0, 1e6, 1e6}, {6, 1e6, 1e6}},
           {86.65811435, 86.65811435, 274.31285391, 274.31285391, 716.78631221, 716.78631221},
           {85.389467, 87.7958637, 251.78460413, 294.71333087, 600.17936195, 827.07536193},
           2e-7},
          {"5.9.2",
           two,
           {{0, 1e6, 0.8e6}, {6, 1e6, 0.8e6}},
           {82.65, 86.66, 254.52, 274.31, 679.49, 716.79},
           {82.33, 86.86, 239.64, 287.25, 583.49, 806.89},
           1e-4},
          {"5.9.9",
           {{6, 0.35}},
           {{0, 1e7, 1e7}, {4, 1e7, 1e7}},
           {90.14, 90.14, 630.73, 630.73, 830.43, 830.43},
           {76.19, 103.91, 565.99, 634.23, 647.75, 1174.2},
           1e-3}};
}

inline model::RotorKit typed(const BookExample& example) {
  model::RotorKit kit;
  kit.shaft = {structure::steel_segment(6 * book_element_m, 0.05)};
  for (const auto& disc : example.discs)
    kit.discs.push_back(
        {disc.node * book_element_m, disc.mass_kg(), disc.polar_kg_m2(), disc.diametral_kg_m2()});
  for (const auto& bearing : example.bearings) {
    kit.supports.push_back(structure::isotropic_support(bearing.node * book_element_m, bearing.x_n_per_m));
    kit.supports.back().stiffness_y_n_per_m = bearing.y_n_per_m;
  }
  kit.elements = 6;
  return kit;
}

inline std::string as_ross_file(const BookExample& example) {
  std::string text = ross_shafts(6, book_element_m);
  int number = 0;
  for (const auto& disc : example.discs)
    text += ross_disc(number++, disc.node, disc.mass_kg(), disc.polar_kg_m2(), disc.diametral_kg_m2());
  number = 0;
  for (const auto& bearing : example.bearings)
    text += ross_bearing(number++, bearing.node,
                         fmt::format("kxx = [{}]\nkyy = [{}]", bearing.x_n_per_m, bearing.y_n_per_m));
  return text;
}

/// Matrices assembled element by element from the book's formulas.
inline model::ShaftMatrices as_matrices(const BookExample& example) {
  std::vector<double> position_m;
  for (int node = 0; node <= 6; ++node) position_m.push_back(node * book_element_m);
  model::ShaftMatrices rotor = structure::empty_matrices(structure::freedoms_at(position_m));
  const structure::BookElement element = structure::book_element(book_element_m, 0.05);
  for (Eigen::Index i = 0; i < 6; ++i) {
    rotor.mass.block<8, 8>(4 * i, 4 * i) += element.mass;
    rotor.gyroscopic.block<8, 8>(4 * i, 4 * i) += element.gyroscopic;
    rotor.stiffness.block<8, 8>(4 * i, 4 * i) += element.stiffness;
  }
  for (const auto& disc : example.discs) {
    const Eigen::Index x = 4 * disc.node, y = x + 1, rx = x + 2, ry = x + 3;
    rotor.mass(x, x) += disc.mass_kg(), rotor.mass(y, y) += disc.mass_kg();
    rotor.mass(rx, rx) += disc.diametral_kg_m2(), rotor.mass(ry, ry) += disc.diametral_kg_m2();
    // Gyroscopic coupling of the rotations about x and y: I_p w turns one rate into a moment about the other
    // axis.
    rotor.gyroscopic(rx, ry) += disc.polar_kg_m2(), rotor.gyroscopic(ry, rx) -= disc.polar_kg_m2();
    rotor.unbalance_kg(x) = disc.mass_kg();
    rotor.unbalance_kg(y) = std::complex<double>(0, -disc.mass_kg());
  }
  for (const auto& bearing : example.bearings) {
    rotor.stiffness(4 * bearing.node, 4 * bearing.node) += bearing.x_n_per_m;
    rotor.stiffness(4 * bearing.node + 1, 4 * bearing.node + 1) += bearing.y_n_per_m;
  }
  return rotor;
}

}  // namespace rubsweep::config::machine
