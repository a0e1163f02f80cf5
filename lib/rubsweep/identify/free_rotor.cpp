#include "rubsweep/identify/free_rotor.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <variant>

#include "rubsweep/numerics/dense/cholesky.hpp"
#include "rubsweep/overloaded.hpp"
#include "rubsweep/structure/beam_shaft.hpp"
#include "rubsweep/structure/jeffcott.hpp"
#include "rubsweep/structure/reduction.hpp"

namespace rubsweep::identify {
namespace {

FreeRotor free_jeffcott(const model::JeffcottRotor& rotor) {
  const structure::Assembly assembly = structure::assemble_jeffcott(rotor, {});
  const structure::LinearSystem& disc = assembly.system;
  FreeRotor free;
  free.system = {disc.mass, disc.damping, Eigen::Matrix2d::Zero(), disc.stiffness, {1, 1}};
  free.circulatory = assembly.circulatory;
  free.spin = Eigen::Matrix2d{{0, rotor.mass_kg}, {-rotor.mass_kg, 0}};
  free.position_m = {0};
  free.x = Eigen::RowVector2d(1, 0);
  free.y = Eigen::RowVector2d(0, 1);
  return free;
}

/// Adds a shape to those of one plane: the static deflection by `force`, less what the others make of it.
void add_deflection(const structure::BeamShaft& shaft, std::size_t plane, const Eigen::VectorXd& force,
                    structure::Reduction& modes) {
  constexpr double nothing = 1e-9;
  const Eigen::MatrixXd stiffness = shaft.plane_stiffness(plane), mass = shaft.plane_mass(plane);
  Eigen::MatrixXd& shapes = modes.bases[plane];
  Eigen::VectorXd shape = numerics::dense::CholeskyFactors(stiffness).solve(force);
  const double whole = std::sqrt(shape.dot(mass * shape));
  for (int pass = 0; pass < 2; ++pass)  // twice is enough: rounding of the first is taken out
    shape -= shapes * (shapes.transpose() * (mass * shape));
  const double size = std::sqrt(shape.dot(mass * shape));
  if (!(size > nothing * whole)) return;
  shape /= size;
  shapes.conservativeResize(Eigen::NoChange, shapes.cols() + 1);
  shapes.rightCols<1>() = shape;
  Eigen::VectorXd& hz = modes.frequency_hz[plane];
  hz.conservativeResize(hz.size() + 1);
  hz(hz.size() - 1) = std::sqrt(shape.dot(stiffness * shape)) / (2 * std::numbers::pi);
}

/// All of the lowest modes of both planes, in the form that structural damping is given to.
structure::Reduction lowest_modes(const structure::BeamShaft& shaft) {
  structure::Reduction modes;
  for (std::size_t plane = 0; plane < 2; ++plane) {
    structure::PlaneModes found =
        structure::plane_modes(shaft.plane_mass(plane), shaft.plane_stiffness(plane), most_plane_modes);
    modes.mode_number[plane].resize(static_cast<std::size_t>(found.rad_per_s.size()));
    std::iota(modes.mode_number[plane].begin(), modes.mode_number[plane].end(), 1);
    modes.frequency_hz[plane] = found.rad_per_s / (2 * std::numbers::pi);
    modes.bases[plane] = std::move(found.shape);
  }
  return modes;
}

FreeRotor free_kit(const model::RotorKit& kit, const std::vector<model::Stop>& stops) {
  std::vector<double> stations_m;
  for (const model::Stop& stop : stops) stations_m.push_back(*stop.position_m);
  structure::BeamShaft shaft = structure::assemble_beam_shaft(kit, stations_m);
  structure::Reduction modes = lowest_modes(shaft);
  for (std::size_t i = 0; i < kit.supports.size(); ++i) {
    if (!kit.supports[i].table) continue;
    for (std::size_t plane = 0; plane < 2; ++plane)
      add_deflection(shaft, plane, structure::support_gap(shaft, kit, i), modes);
  }
  FreeRotor free;
  free.system = structure::reduced_system(shaft, kit, modes);
  if (model::has_rotating_damping(kit)) {
    const structure::RotatingDamping added = structure::rotating_damping(shaft, kit, modes, free.system);
    free.system.damping += added.damping;
    free.circulatory = added.circulatory;
  }
  free.position_m = shaft.node_position_m;
  const Eigen::Index n = free.system.coordinates(), nodes = static_cast<Eigen::Index>(free.position_m.size());
  free.x = free.y = Eigen::MatrixXd::Zero(nodes, n);
  for (Eigen::Index node = 0; node < nodes; ++node) {
    free.x.row(node) = free.system.scatter(0, modes.bases[0].row(2 * node).transpose()).transpose();
    free.y.row(node) = free.system.scatter(1, modes.bases[1].row(2 * node).transpose()).transpose();
  }
  free.tables = structure::tabled_supports(shaft, kit, modes.bases, free.system, n);
  // The mass matrix in place of the gyroscopic one, which couples the planes; the mean of both where they
  // differ.
  shaft.gyroscopic = (shaft.plane_mass(0) + shaft.plane_mass(1)) / 2;
  free.spin = structure::project(shaft, modes.bases).gyroscopic;
  return free;
}

}  // namespace

FreeRotor free_rotor(const model::Machine& machine) {
  return std::visit(overloaded{[](const model::JeffcottRotor& rotor) { return free_jeffcott(rotor); },
                               [&](const model::RotorKit& kit) { return free_kit(kit, machine.stops); }},
                    machine.rotor);
}

FreeRotor rotor_at(const FreeRotor& rotor, double speed_hz) {
  FreeRotor at = rotor;
  at.tables.clear();
  for (const structure::TabledSupport& support : rotor.tables)
    structure::add_lacking(support, 2 * std::numbers::pi * speed_hz, at.system.mass, at.system.damping,
                           at.system.stiffness);
  return at;
}

}  // namespace rubsweep::identify
