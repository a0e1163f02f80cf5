#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::design {

inline constexpr double standard_gravity_m_per_s2 = 9.80665;

/// Whether a support holds nothing: by the name of its element in a file of another program, or because it is
/// a hundred times softer than the stiffest bearing.
bool is_seal(const model::RotorKit& kit, std::size_t support);

/// Indices of the supports that hold the shaft, seals left out, by position.
std::vector<std::size_t> bearings_of(const model::RotorKit& kit);

/// The kit without its seals.
model::RotorKit without_seals(model::RotorKit kit);

/// Stations of the stops of a machine, which are nodes of its shaft.
std::vector<double> stop_stations_m(const model::Machine& machine);

/// Force of the shaft on a bearing, along x and y.
struct BearingLoad {
  std::size_t support = 0;
  std::array<double, 2> load_n{};
};

/// Internal forces at a place of the shaft: `shear_n` is the sum of the forces on the part of the shaft
/// before it, and the moment's derivative along the shaft. A moment > 0 makes the shaft sag: its middle
/// deflects along -x or -y.
struct Section {
  double position_m = 0;
  std::array<double, 2> shear_n{}, moment_nm{};
};

/// Shaft at rest under its weight along -y and constant loads, on its bearings alone, since seals run where
/// the rotor stands. Entries are for the planes of x and y; cross-coupling is left out.
struct StaticLine {
  /// Whether the bearings alone hold the shaft. If not, there is no equilibrium, and no number means
  /// anything.
  bool holds = true;
  std::vector<double> position_m;                ///< nodes, ascending
  std::array<Eigen::VectorXd, 2> deflection_m;   ///< at the nodes
  std::vector<BearingLoad> loads;                ///< in the order of bearings_of
  std::optional<std::vector<Section>> sections;  ///< a node has two where a force acts; empty for matrices,
                                                 ///< which do not tell shaft and bearings apart
};

/// Static line of a kit with these stations among its nodes. Supports with tables have the coefficients in
/// the kit.
StaticLine static_line(const model::RotorKit& kit, const std::vector<double>& stations_m,
                       double gravity_m_per_s2 = standard_gravity_m_per_s2);

}  // namespace rubsweep::design
