#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::model {

/// Direction of a degree of freedom: displacement along x or y in metres, or angle about x or y in radians by
/// the right-hand rule. A shaft along z that bends as x(z) thus turns its cross-section by dx/dz about y;
/// y(z) turns it by -dy/dz about x.
enum class Direction { x, y, rx, ry };

constexpr std::string_view to_string(Direction direction) { return enumerator_word(direction); }

/// One row and column of a rotor's matrices.
struct DegreeOfFreedom {
  std::string node;
  Direction direction = Direction::x;
  std::optional<double> position_m;  ///< along the shaft; empty: belongs to a body beside it
  /// Mass whose weight acts on this degree of freedom: gravity g along -y gives the force -g times this
  /// number (for a direction rx in kg m). Empty: from the mass matrix.
  std::optional<double> weight_kg;
};

/// Unbalance mass at a node; the distance of its centre from the shaft's axis is eccentricity_ratio times the
/// cell's eccentricity.
struct NodeUnbalance {
  std::string node;
  double mass_kg = required;
  double eccentricity_ratio = 1;
  double phase_deg = 0;  ///< angle from the mark on the shaft, in the direction of rotation

  static void visit_fields(auto& self, auto&& visit) {
    visit("mass_kg", self.mass_kg, key(physical::mass_kg, "mass that stands off"));
    visit("eccentricity_ratio", self.eccentricity_ratio,
          key(physical::per_eccentricity, "distance from the axis, per metre of the cell's eccentricity"));
    visit("phase_deg", self.phase_deg, key(any_finite, "angle of that distance"));
  }
};

/// Matrices of a rotor from another program: mass q'' + (damping + w gyroscopic) q' + stiffness q = forces at
/// the speed w in rad/s, each n x n in SI units. At least one of the n degrees of freedom is on the shaft.
struct ShaftMatrices {
  std::vector<DegreeOfFreedom> degrees_of_freedom;  ///< n entries
  Eigen::MatrixXd mass, damping, gyroscopic, stiffness;
  /// n, in kg: an eccentricity e in metres gives the forces Re(e w^2 unbalance_kg e^{i w t}). NaN where the
  /// unbalance is given in the other plane.
  Eigen::VectorXcd unbalance_kg;
  std::vector<NodeUnbalance> unbalance;  ///< further unbalances, added to unbalance_kg

  static constexpr std::size_t most_degrees_of_freedom = 2000;
};

double shaft_length_m(const ShaftMatrices& matrices);  ///< Position of the last node on the shaft, in metres.

/// Sum of mass times eccentricity of all nodes per eccentricity of a cell, in kg, without regard to phases.
double unbalanced_mass_kg(const ShaftMatrices& matrices);

/// Mass of the nodes on the shaft: their weight along y.
double rotor_mass_kg(const ShaftMatrices& matrices);

/// Weight along each degree of freedom in kg: as given, or else the force with which the mass matrix resists
/// a unit acceleration of all nodes along y.
Eigen::VectorXd weight_kg(const ShaftMatrices& matrices);

/// Throws ConfigError where a length differs from the number of degrees of freedom, a number is not finite or
/// out of range, two degrees of freedom are the same, or none is on the shaft. `path` opens every message.
void validate(const ShaftMatrices& matrices, const std::string& path);

}  // namespace rubsweep::model
