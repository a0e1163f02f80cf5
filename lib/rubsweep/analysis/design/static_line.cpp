#include "rubsweep/analysis/design/static_line.hpp"

#include <algorithm>
#include <string>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/beam_element.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"

namespace rubsweep::design {
namespace {

using Eigen::Index;
using structure::BeamShaft;

double held_by(const model::Support& support) {
  return std::min(support.stiffness_x_n_per_m, support.stiffness_y_n_per_m);
}

double stiffness_of(const model::Support& support, std::size_t plane) {
  return plane == 0 ? support.stiffness_x_n_per_m : support.stiffness_y_n_per_m;
}

/// Deflections and angles of one plane under nodal loads.
Eigen::VectorXd sag_of(const BeamShaft& shaft, const model::RotorKit& kit, std::size_t plane,
                       const Eigen::VectorXd& loads_n) {
  if (loads_n.isZero(0)) return loads_n;
  Eigen::MatrixXd stiffness = shaft.plane_stiffness(plane);
  for (std::size_t i = 0; i < kit.supports.size(); ++i) {
    if (!is_seal(kit, i)) continue;
    const Eigen::VectorXd gap = structure::support_gap(shaft, kit, i);
    stiffness -= stiffness_of(kit.supports[i], plane) * gap * gap.transpose();
  }
  return numerics::dense::solve(stiffness, loads_n);
}

/// Piece of shaft behind a node.
struct Piece {
  double length_m = 0, before_kg = 0, behind_kg = 0;  ///< shares of its mass at its ends
  double couple_kg_m = 0;  ///< sum of the moments at its ends under a unit acceleration
};

/// The piece behind each node; empty where the node is the last one before a coupling or the end.
std::vector<std::optional<Piece>> pieces_of(const model::RotorKit& kit, const std::vector<double>& stations_m,
                                            std::size_t nodes) {
  std::vector<std::optional<Piece>> pieces(nodes);
  const structure::BeamMesh mesh = structure::mesh_of(kit, stations_m);
  for (const structure::MeshElement& element : mesh.elements) {
    const Eigen::Vector4d mass =
        structure::layered_element(*element.segment, element.length_m, element.from, element.to).mass *
        Eigen::Vector4d(1, 0, 1, 0);
    pieces[element.first_node] = Piece{element.length_m, mass(0), mass(2), mass(1) + mass(3)};
  }
  return pieces;
}

/// Forces and couples that act on the shaft at each node in one plane, without the weight of its pieces.
struct NodeForces {
  Eigen::VectorXd force_n, couple_nm;
};

NodeForces node_forces(const BeamShaft& shaft, const model::RotorKit& kit, std::size_t plane,
                       const Eigen::VectorXd& loads_n, const Eigen::VectorXd& sag,
                       const std::vector<BearingLoad>& bearings) {
  const auto nodes = static_cast<Index>(shaft.node_position_m.size());
  NodeForces forces{loads_n(Eigen::seqN(0, nodes, 2)), Eigen::VectorXd::Zero(nodes)};
  for (const BearingLoad& bearing : bearings)
    forces.force_n(shaft.deflection(kit.supports[bearing.support].position_m) / 2) -= bearing.load_n[plane];
  for (const model::Support& support : kit.supports) {
    if (support.at_housing) continue;
    const Index w = shaft.deflection(support.position_m);
    forces.couple_nm(w / 2) -= support.angular_stiffness_nm_per_rad * sag(w + 1);
  }
  return forces;
}

/// Computes the internal forces of one plane by equilibrium, from the first node to the last, and adds them
/// to `sections`, which may already hold the forces of the other plane.
void add_sections(const BeamShaft& shaft, const std::vector<std::optional<Piece>>& pieces, NodeForces forces,
                  double acceleration_m_per_s2, std::size_t plane, std::vector<Section>& sections) {
  const std::size_t nodes = pieces.size();
  sections.resize(2 * nodes);
  for (std::size_t k = 0; k < nodes; ++k) {
    if (!pieces[k]) continue;
    forces.force_n(static_cast<Index>(k)) -= acceleration_m_per_s2 * pieces[k]->before_kg;
    forces.force_n(static_cast<Index>(k) + 1) -= acceleration_m_per_s2 * pieces[k]->behind_kg;
  }
  double shear_n = 0, moment_nm = 0;
  for (std::size_t k = 0; k < nodes; ++k) {
    const auto put = [&](Section& section) {
      section.position_m = shaft.node_position_m[k];
      section.shear_n[plane] = shear_n;
      section.moment_nm[plane] = moment_nm;
    };
    put(sections[2 * k]);
    shear_n += forces.force_n(static_cast<Index>(k));
    moment_nm -= forces.couple_nm(static_cast<Index>(k));
    put(sections[2 * k + 1]);
    if (!pieces[k]) continue;
    const Piece& piece = *pieces[k];
    moment_nm += piece.length_m * (shear_n + acceleration_m_per_s2 * piece.before_kg) -
                 acceleration_m_per_s2 * piece.couple_kg_m;
    shear_n += acceleration_m_per_s2 * (piece.before_kg + piece.behind_kg);
  }
}

}  // namespace

bool is_seal(const model::RotorKit& kit, std::size_t support) {
  constexpr double holds_nothing = 0.01;
  if (kit.supports[support].at_housing) return false;
  if (kit.supports[support].name.find("Seal") != std::string::npos) return true;
  double stiffest = 0;
  for (const model::Support& one : kit.supports)
    if (!one.at_housing) stiffest = std::max(stiffest, held_by(one));
  return held_by(kit.supports[support]) < holds_nothing * stiffest;
}

std::vector<std::size_t> bearings_of(const model::RotorKit& kit) {
  std::vector<std::size_t> bearings;
  for (std::size_t i = 0; i < kit.supports.size(); ++i)
    if (!kit.supports[i].at_housing && !is_seal(kit, i)) bearings.push_back(i);
  std::ranges::sort(bearings, {}, [&](std::size_t i) { return kit.supports[i].position_m; });
  return bearings;
}

model::RotorKit without_seals(model::RotorKit kit) {
  const model::RotorKit whole = kit;
  kit.supports.clear();
  for (std::size_t i = 0; i < whole.supports.size(); ++i)
    if (!is_seal(whole, i)) kit.supports.push_back(whole.supports[i]);
  return kit;
}

std::vector<double> stop_stations_m(const model::Machine& machine) {
  std::vector<double> stations_m;
  for (const model::Stop& stop : machine.stops) stations_m.push_back(*stop.position_m);
  return stations_m;
}

StaticLine static_line(const model::RotorKit& kit, const std::vector<double>& stations_m,
                       double gravity_m_per_s2) {
  const BeamShaft shaft = structure::assemble_beam_shaft(kit, stations_m);
  const model::RotorKit bare = without_seals(kit);
  StaticLine line{
      kit.matrices || (supports_hold(bare, 0) && supports_hold(bare, 1)), shaft.node_position_m, {}, {}, {}};
  for (const std::size_t bearing : bearings_of(kit)) line.loads.push_back({bearing, {}});
  std::vector<std::optional<Piece>> pieces;
  if (!kit.matrices) {
    pieces = pieces_of(kit, stations_m, line.position_m.size());
    line.sections.emplace();
  }
  const std::array<double, 2> acceleration{0, -gravity_m_per_s2};
  for (std::size_t plane = 0; plane < 2; ++plane) {
    Eigen::VectorXd loads_n = acceleration[plane] * shaft.weight_kg;
    for (const model::StaticLoad& load : kit.static_loads)
      loads_n(shaft.deflection(load.position_m)) += plane == 0 ? load.force_x_n : load.force_y_n;
    const Eigen::VectorXd sag = sag_of(shaft, kit, plane, loads_n);
    line.holds = line.holds && sag.allFinite();
    line.deflection_m[plane] = sag(Eigen::seqN(0, static_cast<Index>(line.position_m.size()), 2));
    for (BearingLoad& bearing : line.loads)
      bearing.load_n[plane] = stiffness_of(kit.supports[bearing.support], plane) *
                              structure::support_gap(shaft, kit, bearing.support).dot(sag);
    if (line.sections)
      add_sections(shaft, pieces, node_forces(shaft, kit, plane, loads_n, sag, line.loads),
                   acceleration[plane], plane, *line.sections);
  }
  return line;
}

}  // namespace rubsweep::design
