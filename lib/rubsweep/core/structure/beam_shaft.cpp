#include "rubsweep/core/structure/beam_shaft.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/beam_element.hpp"
#include "rubsweep/core/structure/matrix_shaft.hpp"
#include "rubsweep/core/structure/support_mass.hpp"

namespace rubsweep::structure {
namespace {

/// Adds a spring or damper between two coordinates.
void connect(Eigen::MatrixXd& matrix, Eigen::Index a, Eigen::Index b, double value) {
  matrix(a, a) += value;
  matrix(b, b) += value;
  matrix(a, b) -= value;
  matrix(b, a) -= value;
}

void add_shaft(const BeamMesh& mesh, BeamShaft& shaft) {
  for (const MeshElement& element : mesh.elements) {
    const BeamElement beam = layered_element(*element.segment, element.length_m, element.from, element.to);
    const auto first = static_cast<Eigen::Index>(2 * element.first_node);
    shaft.mass.block<4, 4>(first, first) += beam.mass;
    shaft.gyroscopic.block<4, 4>(first, first) += beam.gyroscopic;
    shaft.damping.block<4, 4>(first, first) += beam.damping;
    shaft.elastic.block<4, 4>(first, first) += beam.stiffness;
    shaft.polar_inertia_kg_m2 += beam.polar_inertia_kg_m2;
  }
}

void add_disc(const model::Disc& disc, BeamShaft& shaft) {
  const Eigen::Index w = shaft.deflection(disc.position_m), s = w + 1;
  shaft.mass(w, w) += disc.mass_kg;
  shaft.mass(s, s) += disc.diametral_inertia_kg_m2;
  shaft.gyroscopic(s, s) += disc.polar_inertia_kg_m2;
  shaft.polar_inertia_kg_m2 += disc.polar_inertia_kg_m2;
  shaft.unbalance_kg(w) += phasor(disc.mass_kg * disc.eccentricity_ratio, disc.eccentricity_phase_deg);
  // A disc tilted by t e^{i w t} against the shaft exerts the moment (I_d - I_p) w^2 t e^{i w t}.
  const double leaning = (disc.diametral_inertia_kg_m2 - disc.polar_inertia_kg_m2) * disc.skew_rad_per_m;
  shaft.unbalance_kg(s) += phasor(leaning, disc.skew_phase_deg);
}

void add_to_both(std::array<Eigen::MatrixXd, 2>& mass, Eigen::Index at, double x_kg,
                 const std::optional<double>& y_kg) {
  mass[0](at, at) += x_kg;
  mass[1](at, at) += y_kg.value_or(x_kg);
}

void add_pedestal(const model::Pedestal& housing, Eigen::Index at, BeamShaft& shaft) {
  shaft.mass(at, at) += housing.mass_kg;
  shaft.support_stiffness[0][0](at, at) += housing.stiffness_x_n_per_m;
  shaft.support_stiffness[1][1](at, at) += housing.stiffness_y_n_per_m;
  shaft.support_damping[0][0](at, at) += housing.damping_x_ns_per_m;
  shaft.support_damping[1][1](at, at) += housing.damping_y_ns_per_m;
}

/// Adds a support. `on`: coordinate of its base; empty: the ground.
void add_support(const model::Support& support, std::optional<Eigen::Index> on, BeamShaft& shaft) {
  const Eigen::Index w = support.at_housing ? shaft.housings[static_cast<std::size_t>(*support.at_housing)]
                                            : shaft.deflection(support.position_m);
  const double k[2][2] = {{support.stiffness_x_n_per_m, support.stiffness_xy_n_per_m},
                          {support.stiffness_yx_n_per_m, support.stiffness_y_n_per_m}};
  const double c[2][2] = {{support.damping_x_ns_per_m, support.damping_xy_ns_per_m},
                          {support.damping_yx_ns_per_m, support.damping_y_ns_per_m}};
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 2; ++b) {
      if (on) {
        connect(shaft.support_stiffness[a][b], w, *on, k[a][b]);
        connect(shaft.support_damping[a][b], w, *on, c[a][b]);
      } else {
        shaft.support_stiffness[a][b](w, w) += k[a][b];
        shaft.support_damping[a][b](w, w) += c[a][b];
      }
    }
    const double added_kg = a == 0 ? support.mass_x_kg : support.mass_y_kg;
    if (on) {
      connect(shaft.added_mass[a], w, *on, added_kg);
    } else {
      shaft.added_mass[a](w, w) += added_kg;
    }
    if (!support.at_housing)
      shaft.support_stiffness[a][a](w + 1, w + 1) += support.angular_stiffness_nm_per_rad;
  }
}

/// Adds the supports and their pedestals, whose coordinates begin at `next`.
void add_supports(const model::RotorKit& kit, Eigen::Index next, BeamShaft& shaft) {
  for (const auto& support : kit.supports) {
    std::optional<Eigen::Index> on;
    if (support.on_housing) on = shaft.housings[static_cast<std::size_t>(*support.on_housing)];
    shaft.pedestals.push_back(support.pedestal ? std::optional(next++) : std::nullopt);
    if (support.pedestal) on = shaft.pedestals.back();
    add_support(support, on, shaft);
    if (support.pedestal) add_pedestal(*support.pedestal, *on, shaft);
  }
}

void add_point_masses(const model::RotorKit& kit, BeamShaft& shaft) {
  for (const auto& point : kit.point_masses)
    add_to_both(shaft.added_mass, shaft.deflection(point.position_m), point.mass_kg, point.mass_y_kg);
  for (std::size_t i = 0; i < kit.housings.size(); ++i)
    add_to_both(shaft.added_mass, shaft.housings[i], kit.housings[i].mass_kg, kit.housings[i].mass_y_kg);
}

std::optional<Eigen::Index> find_deflection(const std::vector<double>& node_position_m, double position_m) {
  // Tolerance slightly above the distance at which stations are merged: rounding of either does not matter.
  const double tolerance = (1 + 1e-3) * same_place * node_position_m.back();
  for (std::size_t node = 0; node < node_position_m.size(); ++node) {
    if (std::abs(node_position_m[node] - position_m) <= tolerance) return static_cast<Eigen::Index>(2 * node);
  }
  return std::nullopt;
}

/// Shaft from the matrices of a kit, with added coordinates for the pedestals of its supports.
BeamShaft assemble_matrices(const model::RotorKit& kit, std::vector<double> stations) {
  BeamShaft shaft = matrix_shaft(*kit.matrices);
  add_places(kit, stations);
  for (const double station : stations) {
    if (!find_deflection(shaft.node_position_m, station))
      throw ConfigError(
          "rotor.degrees_of_freedom: has no node at " + std::to_string(station) +
          " m, where a stop, kick, sensor, load or support stands, allowed: such places at nodes");
  }
  const Eigen::Index first = shaft.coordinates();
  Eigen::Index n = first;
  for (const auto& support : kit.supports) n += support.pedestal ? 1 : 0;
  const auto enlarge = [&](Eigen::MatrixXd& matrix) {
    matrix.conservativeResizeLike(Eigen::MatrixXd::Zero(n, n));
  };
  for (Eigen::MatrixXd* matrix : {&shaft.mass, &shaft.gyroscopic, &shaft.damping, &shaft.elastic,
                                  &shaft.added_mass[0], &shaft.added_mass[1]})
    enlarge(*matrix);
  for (PlanePairs* pairs : {&shaft.support_stiffness, &shaft.support_damping}) {
    for (auto& row : *pairs) std::ranges::for_each(row, enlarge);
  }
  shaft.unbalance_kg.conservativeResizeLike(Eigen::VectorXcd::Zero(n));
  shaft.weight_kg.conservativeResizeLike(Eigen::VectorXd::Zero(n));
  add_supports(kit, first, shaft);
  for (std::size_t i = 0; i < kit.supports.size(); ++i) {
    if (const auto at = shaft.pedestals[i]) shaft.weight_kg(*at) = kit.supports[i].pedestal->mass_kg;
  }
  keep_mass_positive(kit, shaft);
  return shaft;
}

}  // namespace

Eigen::Index BeamShaft::deflection(double position_m) const {
  if (const auto found = find_deflection(node_position_m, position_m)) return *found;
  throw SolverError("beam shaft: there is no node at a station");
}

BeamShaft assemble_beam_shaft(const model::RotorKit& kit, const std::vector<double>& stations_m) {
  if (kit.matrices) return assemble_matrices(kit, stations_m);
  const BeamMesh mesh = mesh_of(kit, stations_m);
  BeamShaft shaft;
  shaft.node_position_m = mesh.node_position_m;
  const auto on_shaft = static_cast<Eigen::Index>(2 * mesh.node_position_m.size());
  Eigen::Index n = on_shaft;
  for (const auto& support : kit.supports) n += support.pedestal ? 1 : 0;
  for (std::size_t i = 0; i < kit.housings.size(); ++i) shaft.housings.push_back(n++);
  shaft.mass = shaft.gyroscopic = shaft.damping = shaft.elastic = Eigen::MatrixXd::Zero(n, n);
  shaft.added_mass.fill(Eigen::MatrixXd::Zero(n, n));
  for (auto* pairs : {&shaft.support_stiffness, &shaft.support_damping}) {
    for (auto& row : *pairs) row.fill(Eigen::MatrixXd::Zero(n, n));
  }
  shaft.unbalance_kg = Eigen::VectorXcd::Zero(n);
  add_shaft(mesh, shaft);
  for (const auto& coupling : kit.couplings) {
    const Eigen::Index w = shaft.deflection(coupling.position_m);
    connect(shaft.elastic, w, w + 2, coupling.lateral_stiffness_n_per_m);
    connect(shaft.elastic, w + 1, w + 3, coupling.angular_stiffness_nm_per_rad);
  }
  for (const auto& disc : kit.discs) add_disc(disc, shaft);
  add_point_masses(kit, shaft);
  const Eigen::MatrixXd of_points = shaft.added_mass[1];
  shaft.damping += kit.mass_damping_per_s * shaft.mass;
  for (std::size_t a = 0; a < 2; ++a)
    shaft.support_damping[a][a] += kit.mass_damping_per_s * shaft.added_mass[a];
  add_supports(kit, on_shaft, shaft);
  // Rigid translation: deflections 1, angles 0. The consistent mass makes the static sag exact at the nodes.
  Eigen::VectorXd translation = Eigen::VectorXd::Ones(n);
  for (Eigen::Index s = 1; s < on_shaft; s += 2) translation(s) = 0;
  // Weight along y, without the fluid in supports, whose mass adds no weight.
  shaft.weight_kg = (shaft.mass + of_points) * translation;
  keep_mass_positive(kit, shaft);
  return shaft;
}

Eigen::VectorXd support_gap(const BeamShaft& shaft, const model::RotorKit& kit, std::size_t support) {
  const model::Support& at = kit.supports[support];
  const auto housing = [&](int number) { return shaft.housings[static_cast<std::size_t>(number)]; };
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(shaft.coordinates());
  gap(at.at_housing ? housing(*at.at_housing) : shaft.deflection(at.position_m)) = 1;
  if (shaft.pedestals[support]) gap(*shaft.pedestals[support]) = -1;
  if (at.on_housing) gap(housing(*at.on_housing)) = -1;
  return gap;
}

Eigen::VectorXd least_bent_line(const BeamShaft& shaft, const model::BowPoints& points) {
  const auto n = static_cast<Eigen::Index>(2 * shaft.node_position_m.size());
  const auto count = static_cast<Eigen::Index>(points.position_m.size());
  // The elastic energy is stationary under the constraints. The equations are scaled, so that the multipliers
  // are not much larger than the shape.
  const auto elastic = shaft.elastic.topLeftCorner(n, n);
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + count, n + count);
  system.topLeftCorner(n, n) = elastic / elastic.cwiseAbs().maxCoeff();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const Eigen::Index w = shaft.deflection(points.position_m[index]);
    system(n + i, w) = system(w, n + i) = 1;
    right(n + i) = points.deflection_m[index];
  }
  Eigen::VectorXd line = Eigen::VectorXd::Zero(shaft.coordinates());
  line.head(n) = numerics::dense::solve_full_pivot(system, right).head(n);
  return line;
}

}  // namespace rubsweep::structure
