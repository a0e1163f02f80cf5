#include "rubsweep/core/model/shaft_matrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::model {
namespace {

void require(const std::string& path, const std::string& key, double value, const Range& range) {
  if (contains(range, value)) return;
  throw ConfigError(fmt::format("{}{}: {} is out of range, allowed: {}", path, key, value, describe(range)));
}

void validate(const std::vector<DegreeOfFreedom>& all, const std::string& path) {
  std::set<std::pair<std::string, Direction>> seen;
  bool any_on_shaft = false;
  for (const DegreeOfFreedom& one : all) {
    if (!seen.emplace(one.node, one.direction).second)
      throw ConfigError(fmt::format("{}degrees_of_freedom: {} of node {} stands twice, allowed: each once",
                                    path, to_string(one.direction), one.node));
    any_on_shaft = any_on_shaft || one.position_m;
    if (one.position_m)
      require(path, "degrees_of_freedom.position_m", *one.position_m,
              {.low = 0, .high = physical::length_m.high});
    if (one.weight_kg) require(path, "degrees_of_freedom.weight_kg", *one.weight_kg, any_finite);
  }
  if (!any_on_shaft)
    throw ConfigError(path +
                      "degrees_of_freedom: no node is on the shaft, allowed: a position_m for at least one");
  if (all.size() > ShaftMatrices::most_degrees_of_freedom)
    throw ConfigError(fmt::format("{}degrees_of_freedom: {} of them, allowed: at most {}", path, all.size(),
                                  ShaftMatrices::most_degrees_of_freedom));
}

}  // namespace

double shaft_length_m(const ShaftMatrices& matrices) {
  double length_m = 0;
  for (const DegreeOfFreedom& one : matrices.degrees_of_freedom)
    length_m = std::max(length_m, one.position_m.value_or(0));
  return length_m;
}

double unbalanced_mass_kg(const ShaftMatrices& matrices) {
  std::map<std::string, double> of_node;  // mass at each node, the same in both planes because it turns
  for (std::size_t i = 0; i < matrices.degrees_of_freedom.size(); ++i) {
    const auto& [node, direction, position_m, weight] = matrices.degrees_of_freedom[i];
    const double size = std::abs(matrices.unbalance_kg(static_cast<Eigen::Index>(i)));
    if ((direction == Direction::x || direction == Direction::y) && size > of_node[node])
      of_node[node] = size;
  }
  double mass_kg = 0;
  for (const auto& [node, size] : of_node) mass_kg += size;
  for (const NodeUnbalance& one : matrices.unbalance)
    mass_kg += one.mass_kg * std::abs(one.eccentricity_ratio);
  return mass_kg;
}

double rotor_mass_kg(const ShaftMatrices& matrices) {
  const Eigen::VectorXd weight = weight_kg(matrices);
  double mass_kg = 0;
  for (std::size_t i = 0; i < matrices.degrees_of_freedom.size(); ++i) {
    const DegreeOfFreedom& one = matrices.degrees_of_freedom[i];
    if (one.direction == Direction::y && one.position_m) mass_kg += weight(static_cast<Eigen::Index>(i));
  }
  return mass_kg;
}

Eigen::VectorXd weight_kg(const ShaftMatrices& matrices) {
  const auto& all = matrices.degrees_of_freedom;
  const auto n = static_cast<Eigen::Index>(all.size());
  Eigen::VectorXd translation = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i)
    translation(i) = all[static_cast<std::size_t>(i)].direction == Direction::y;
  Eigen::VectorXd weight = matrices.mass * translation;
  for (Eigen::Index i = 0; i < n; ++i)
    weight(i) = all[static_cast<std::size_t>(i)].weight_kg.value_or(weight(i));
  return weight;
}

void validate(const ShaftMatrices& matrices, const std::string& path) {
  validate(matrices.degrees_of_freedom, path);
  const auto n = static_cast<Eigen::Index>(matrices.degrees_of_freedom.size());
  for (const auto& [name, matrix] : {std::pair("mass", &matrices.mass),
                                     {"damping", &matrices.damping},
                                     {"gyroscopic", &matrices.gyroscopic},
                                     {"stiffness", &matrices.stiffness}}) {
    if (matrix->rows() != n || matrix->cols() != n)
      throw ConfigError(fmt::format("{0}{1}: is {2} x {3}, allowed: {4} x {4}, as many as degrees_of_freedom",
                                    path, name, matrix->rows(), matrix->cols(), n));
    if (!matrix->allFinite())
      throw ConfigError(
          fmt::format("{}{}: holds a number that is not finite, allowed: finite ones", path, name));
  }
  if (matrices.unbalance_kg.size() != n)
    throw ConfigError(fmt::format("{}unbalance: has {} numbers, allowed: {}, as many as degrees_of_freedom",
                                  path, matrices.unbalance_kg.size(), n));
  for (const NodeUnbalance& one : matrices.unbalance) {
    require(path, "unbalance.mass_kg", one.mass_kg, physical::mass_kg);
    require(path, "unbalance.eccentricity_ratio", one.eccentricity_ratio, physical::per_eccentricity);
    require(path, "unbalance.phase_deg", one.phase_deg, any_finite);
    const bool known = std::ranges::any_of(matrices.degrees_of_freedom, [&](const DegreeOfFreedom& other) {
      return other.node == one.node && other.position_m;
    });
    if (!known)
      throw ConfigError(
          fmt::format("{}unbalance.node: '{}' is not on the shaft, allowed: a node of "
                      "degrees_of_freedom with a position_m",
                      path, one.node));
  }
}

}  // namespace rubsweep::model
