#include "rubsweep/analysis/design/critical_map.hpp"

#include <array>
#include <cstddef>
#include <numbers>
#include <variant>

#include "rubsweep/analysis/design/static_line.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"
#include "rubsweep/core/structure/lateral_system.hpp"

namespace rubsweep::design {
namespace {

/// The kit with springs of no stiffness in place of its bearings, and without seals; `bearings` are their new
/// indices.
model::RotorKit without_bearings(const model::RotorKit& kit, std::vector<std::size_t>& bearings) {
  model::RotorKit bare = kit;
  bare.supports.clear();
  for (std::size_t i = 0; i < kit.supports.size(); ++i) {
    model::Support support = kit.supports[i];
    if (!support.at_housing) {
      if (is_seal(kit, i)) continue;
      bearings.push_back(bare.supports.size());
      model::set_coefficients(support, {});
      support.angular_stiffness_nm_per_rad = 0;
      support.table.reset();
    }
    bare.supports.push_back(support);
  }
  return bare;
}

}  // namespace

std::vector<CriticalSpeedsAt> critical_map(const model::RotorKit& kit, const std::vector<double>& stations_m,
                                           std::span<const double> stiffness_n_per_m, int modes) {
  std::vector<std::size_t> bearings;
  const model::RotorKit bare = without_bearings(kit, bearings);
  if (bearings.empty()) return {};
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(bare, stations_m);
  // A forward whirl at the speed w feels w^2 (mass - gyroscopic).
  const Eigen::MatrixXd mass = (shaft.plane_mass(0) + shaft.plane_mass(1)) / 2 - shaft.gyroscopic,
                        held = (shaft.plane_stiffness(0) + shaft.plane_stiffness(1)) / 2;
  Eigen::MatrixXd springs = Eigen::MatrixXd::Zero(held.rows(), held.cols());
  for (const std::size_t bearing : bearings) {
    const Eigen::VectorXd gap = structure::support_gap(shaft, bare, bearing);
    springs += gap * gap.transpose();
  }
  std::vector<CriticalSpeedsAt> map;
  for (const double stiffness : stiffness_n_per_m) {
    const structure::PlaneModes found = structure::plane_modes(mass, held + stiffness * springs, modes);
    CriticalSpeedsAt& at = map.emplace_back(CriticalSpeedsAt{stiffness, {}});
    for (const double rad_per_s : found.rad_per_s) at.speed_hz.push_back(rad_per_s / (2 * std::numbers::pi));
  }
  return map;
}

std::optional<double> rigid_critical_hz(const model::Machine& machine) try {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr) return std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz;
  // Bearings are rigid from where a tenfold stiffness changes nothing.
  constexpr double same = 1e-6, softest = 1e4, stiffest = 1e17;
  double last_hz = 0;
  for (double stiffness = softest; stiffness < stiffest; stiffness *= 10) {
    const auto map = critical_map(*kit, stop_stations_m(machine), std::array{stiffness}, 1);
    if (map.empty() || map.front().speed_hz.empty()) return std::nullopt;
    const double hz = map.front().speed_hz.front();
    if (hz - last_hz <= same * hz) return hz;
    last_hz = hz;
  }
  return std::nullopt;
} catch (const ConfigError&) {
  return std::nullopt;  // of matrices, or beyond the rounding of the shaft
}

}  // namespace rubsweep::design
