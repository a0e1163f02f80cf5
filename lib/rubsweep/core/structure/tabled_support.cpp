#include "rubsweep/core/structure/tabled_support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/model/speed_text.hpp"

namespace rubsweep::structure {
namespace {

template <std::size_t... column>
SupportCurves curves_of(const model::SupportTable& table, std::index_sequence<column...>) {
  return {numerics::Pchip(table.speed_hz, table.columns[column])...};
}

void refuse_beyond(const model::SupportTable& table, double speed_hz, const std::string& path) {
  const double low = table.speed_hz.front(), high = table.speed_hz.back();
  if (speed_hz >= low && speed_hz <= high) return;
  throw ConfigError(fmt::format("{}table: does not reach {}, allowed: speeds from {}", path,
                                model::speed_text(speed_hz), model::speed_range_text(low, high)));
}

}  // namespace

SupportCurves curves_of(const model::SupportTable& table) {
  return curves_of(table, std::make_index_sequence<model::support_coefficients.size()>{});
}

SupportMatrices TabledSupport::lacking(double speed_rad_per_s) const {
  const double hz = speed_rad_per_s / (2 * std::numbers::pi);
  SupportMatrices at;
  at.stiffness << curves[0](hz), curves[1](hz), curves[2](hz), curves[3](hz);
  at.damping << curves[4](hz), curves[5](hz), curves[6](hz), curves[7](hz);
  at.mass << curves[8](hz), curves[9](hz);
  at.stiffness -= built_in.stiffness;
  at.damping -= built_in.damping;
  at.mass -= built_in.mass;
  return at;
}

TabledSupport tabled_support(const model::Support& support) {
  TabledSupport tabled{{}, curves_of(*support.table), {{}, {}, {support.mass_x_kg, support.mass_y_kg}}};
  tabled.built_in.stiffness << support.stiffness_x_n_per_m, support.stiffness_xy_n_per_m,
      support.stiffness_yx_n_per_m, support.stiffness_y_n_per_m;
  tabled.built_in.damping << support.damping_x_ns_per_m, support.damping_xy_ns_per_m,
      support.damping_yx_ns_per_m, support.damping_y_ns_per_m;
  return tabled;
}

void add_lacking(const TabledSupport& support, double speed_rad_per_s, Eigen::MatrixXd& mass,
                 Eigen::MatrixXd& damping, Eigen::MatrixXd& stiffness) {
  const SupportMatrices lacking = support.lacking(speed_rad_per_s);
  std::vector<Eigen::Index> moved;
  for (Eigen::Index i = 0; i < support.map.cols(); ++i)
    if (!support.map.col(i).isZero(0)) moved.push_back(i);
  // Only two of the hundreds of coordinates of a whole shaft move a support.
  if (2 * static_cast<Eigen::Index>(moved.size()) <= support.map.cols()) {
    const auto map = support.map(Eigen::all, moved);
    stiffness(moved, moved) += map.transpose() * lacking.stiffness * map;
    damping(moved, moved) += map.transpose() * lacking.damping * map;
    mass(moved, moved) += map.transpose() * lacking.mass.asDiagonal() * map;
    return;
  }
  stiffness += support.map.transpose() * lacking.stiffness * support.map;
  damping += support.map.transpose() * lacking.damping * support.map;
  mass += support.map.transpose() * lacking.mass.asDiagonal() * support.map;
}

model::Support support_at(const model::Support& support, double speed_hz, const std::string& path) {
  if (!support.table) return support;
  refuse_beyond(*support.table, speed_hz, path);
  const SupportCurves curves = curves_of(*support.table);
  std::array<double, model::support_coefficients.size()> values{};
  for (std::size_t c = 0; c < values.size(); ++c) values[c] = curves[c](speed_hz);
  model::Support at = support;
  at.table.reset();
  model::set_coefficients(at, values);
  return at;
}

model::Machine machine_at(const model::Machine& machine, double speed_hz) {
  model::Machine at = machine;
  if (model::RotorKit* kit = model::kit_of(at)) {
    for (std::size_t i = 0; i < kit->supports.size(); ++i)
      kit->supports[i] = support_at(kit->supports[i], speed_hz, model::support_path(*kit, i) + ".");
  }
  return at;
}

void refuse_beyond_tables(const model::Machine& machine, double low_hz, double high_hz) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr) return;
  for (std::size_t i = 0; i < kit->supports.size(); ++i) {
    if (!kit->supports[i].table) continue;
    refuse_beyond(*kit->supports[i].table, low_hz, model::support_path(*kit, i) + ".");
    refuse_beyond(*kit->supports[i].table, high_hz, model::support_path(*kit, i) + ".");
  }
}

void refuse_changing_mass(const model::Machine& machine, const std::string& what) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr) return;
  const auto changes = [](const std::vector<double>& column) {
    return std::ranges::any_of(column, [&](double value) { return value != column.front(); });
  };
  for (std::size_t i = 0; i < kit->supports.size(); ++i) {
    const auto& table = kit->supports[i].table;
    if (table && (changes(table->columns[8]) || changes(table->columns[9])))
      throw ConfigError(
          model::support_path(*kit, i) + ".table: " + what +
          " cannot follow a mass that changes with the speed, allowed: mxx and myy that stay the same");
  }
}

}  // namespace rubsweep::structure
