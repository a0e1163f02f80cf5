#include "rubsweep/analysis/linear/free_rotor.hpp"

#include <variant>

#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"
#include "rubsweep/core/structure/jeffcott.hpp"

namespace rubsweep::linear {
namespace {

FreeRotor free_jeffcott(const model::JeffcottRotor& rotor) {
  const structure::Assembly assembly = structure::assemble_jeffcott(rotor, {});
  const structure::LinearSystem& disc = assembly.system;
  FreeRotor free;
  free.full.system = {disc.mass, disc.damping, Eigen::Matrix2d::Zero(), disc.stiffness, {1, 1}};
  free.full.circulatory = assembly.circulatory;
  free.spin = Eigen::Matrix2d{{0, rotor.mass_kg}, {-rotor.mass_kg, 0}};
  free.position_m = {0};
  free.x = Eigen::RowVector2d(1, 0);
  free.y = Eigen::RowVector2d(0, 1);
  return free;
}

FreeRotor free_kit(const model::RotorKit& kit, const std::vector<model::Stop>& stops) {
  std::vector<double> stations_m;
  for (const model::Stop& stop : stops) stations_m.push_back(*stop.position_m);
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(kit, stations_m);
  FreeRotor free;
  free.full = structure::full_system(shaft, kit);
  free.position_m = shaft.node_position_m;
  const structure::LateralSystem& system = free.full.system;
  const Eigen::Index n = system.coordinates(), nodes = static_cast<Eigen::Index>(free.position_m.size());
  free.x = free.y = Eigen::MatrixXd::Zero(nodes, n);
  for (Eigen::Index node = 0; node < nodes; ++node) {
    free.x(node, system.index(0, 2 * node)) = 1;
    free.y(node, system.index(1, 2 * node)) = 1;
  }
  // The mean of both planes where their masses differ.
  const Eigen::MatrixXd mass = (shaft.plane_mass(0) + shaft.plane_mass(1)) / 2;
  free.spin = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < mass.rows(); ++i) {
    for (Eigen::Index k = 0; k < mass.cols(); ++k) {
      free.spin(system.index(0, i), system.index(1, k)) = mass(i, k);
      free.spin(system.index(1, i), system.index(0, k)) = -mass(i, k);
    }
  }
  return free;
}

}  // namespace

FreeRotor free_rotor(const model::Machine& machine) {
  return std::visit(overloaded{[](const model::JeffcottRotor& rotor) { return free_jeffcott(rotor); },
                               [&](const model::RotorKit& kit) { return free_kit(kit, machine.stops); }},
                    machine.rotor);
}

}  // namespace rubsweep::linear
