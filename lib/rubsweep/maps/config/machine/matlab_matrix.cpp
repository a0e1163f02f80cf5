#include "rubsweep/maps/config/machine/matlab_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "rubsweep/maps/matlab/read_file.hpp"

namespace rubsweep::config::machine {
namespace {

using matlab::Variable;

constexpr std::string_view allowed_matrix = "a square matrix of real numbers, full or sparse";

std::nullopt_t refuse_missing(const std::vector<Variable>& variables, const std::string& variable,
                              const yaml::Value& value) {
  std::vector<std::string_view> known;
  for (const Variable& one : variables) known.push_back(one.name);
  const auto meant = yaml::nearest(variable, known);
  std::string list;
  for (const std::string_view name : known)
    list += fmt::format("{}{}", list.empty() ? "" : ", ", yaml::shown(name));
  return refuse(value,
                fmt::format("the file holds no '{}'{}", yaml::shown(variable),
                            meant ? fmt::format(" (did you mean '{}'?)", yaml::shown(*meant)) : ""),
                list.empty() ? "a file that holds one" : "variable: with one of " + yaml::shown(list, 200));
}

}  // namespace

std::optional<Eigen::MatrixXd> read_matlab_matrix(std::string_view bytes, const std::string& variable,
                                                  const yaml::Value& value) {
  constexpr std::size_t most = model::ShaftMatrices::most_degrees_of_freedom;
  std::vector<Variable> variables;
  try {
    variables = matlab::read_variables(bytes, [&](const Variable& one) {
      return one.name == variable && one.is_real_matrix() && one.dims[0] == one.dims[1] &&
             one.dims[0] <= most;
    });
  } catch (const matlab::FileError& error) {
    return refuse(value, "the file " + error.wrong, error.allowed);
  }
  const auto found = std::ranges::find(variables, variable, &Variable::name);
  if (found == variables.end()) return refuse_missing(variables, variable, value);
  const auto refuse_it = [&](const std::string& why) {
    return refuse(value, fmt::format("'{}' {}", yaml::shown(variable), why), allowed_matrix);
  };
  if (found->dims.size() != 2) return refuse_it("is no matrix");
  if (found->complex) return refuse_it("is complex");
  const std::size_t n = found->dims[0];
  if (n == 0 || n != found->dims[1]) return refuse_it(fmt::format("is {} x {}", n, found->dims[1]));
  if (n > most) return refuse_it(fmt::format("has more than {} rows", most));
  if (found->values.size() != n * n) return refuse_it("holds no real numbers");
  const auto rows = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd matrix = Eigen::Map<const Eigen::MatrixXd>(found->values.data(), rows, rows);
  if (!matrix.allFinite()) return refuse_it("holds a number that is not finite");
  return matrix;
}

}  // namespace rubsweep::config::machine
