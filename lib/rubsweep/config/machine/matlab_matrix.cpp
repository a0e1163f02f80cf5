#include "rubsweep/config/machine/matlab_matrix.hpp"

#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "rubsweep/config/yaml/nearest.hpp"
#include "rubsweep/config/yaml/text.hpp"
#include "rubsweep/model/shaft_matrices.hpp"

namespace rubsweep::config::machine {
namespace {

struct CloseFile {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using File = std::unique_ptr<mat_t, CloseFile>;
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

constexpr std::string_view allowed_matrix = "a square matrix of real numbers, full or sparse";

std::vector<std::string> names_in(mat_t* file) {
  std::size_t count = 0;
  char* const* names = Mat_GetDir(file, &count);
  std::vector<std::string> found;
  for (std::size_t i = 0; names != nullptr && i < count; ++i) {
    if (names[i] != nullptr) found.emplace_back(names[i]);
  }
  return found;
}

void refuse_missing(const std::vector<std::string>& names, const std::string& variable,
                    const yaml::Value& value) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto meant = yaml::nearest(variable, known);
  std::string list;
  for (const std::string_view name : known)
    list += fmt::format("{}{}", list.empty() ? "" : ", ", yaml::shown(name));
  refuse(value,
         fmt::format("the file holds no '{}'{}", yaml::shown(variable),
                     meant ? fmt::format(" (did you mean '{}'?)", yaml::shown(*meant)) : ""),
         list.empty() ? "a file that holds one" : "variable: with one of " + yaml::shown(list, 200));
}

std::optional<Eigen::MatrixXd> full(const matvar_t& variable, Eigen::Index n) {
  const auto count = static_cast<std::size_t>(n * n);
  if (variable.data == nullptr || variable.nbytes < count * static_cast<std::size_t>(variable.data_size))
    return std::nullopt;
  if (variable.class_type == MAT_C_DOUBLE && variable.data_type == MAT_T_DOUBLE)
    return Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(variable.data), n, n);
  if (variable.class_type == MAT_C_SINGLE && variable.data_type == MAT_T_SINGLE)
    return Eigen::Map<const Eigen::MatrixXf>(static_cast<const float*>(variable.data), n, n).cast<double>();
  return std::nullopt;
}

std::optional<Eigen::MatrixXd> sparse(const matvar_t& variable, Eigen::Index n) {
  const auto* stored = static_cast<const mat_sparse_t*>(variable.data);
  if (stored == nullptr || variable.data_type != MAT_T_DOUBLE ||
      static_cast<Eigen::Index>(stored->njc) != n + 1)
    return std::nullopt;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index column = 0; column < n; ++column) {
    const auto begin = stored->jc[column], end = stored->jc[column + 1];
    if (begin > end || end > stored->ndata || end > stored->nir) return std::nullopt;
    for (auto k = begin; k < end; ++k) {
      const auto row = static_cast<Eigen::Index>(stored->ir[k]);
      if (row >= n) return std::nullopt;
      matrix(row, column) += static_cast<const double*>(stored->data)[k];
    }
  }
  return matrix;
}

}  // namespace

std::optional<Eigen::MatrixXd> read_matlab_matrix(const std::filesystem::path& file,
                                                  const std::string& variable, const yaml::Value& value) {
  const File open(Mat_Open(file.c_str(), MAT_ACC_RDONLY));
  if (!open) {
    refuse(value, "the file is no MATLAB file, or a damaged one", "a file of version 4, 5 or 7.3");
    return std::nullopt;
  }
  const std::vector<std::string> names = names_in(open.get());
  if (std::ranges::find(names, variable) == names.end()) {
    refuse_missing(names, variable, value);
    return std::nullopt;
  }
  const Variable head(Mat_VarReadInfo(open.get(), variable.c_str()));
  const auto refuse_it = [&](const std::string& why) {
    refuse(value, fmt::format("'{}' {}", yaml::shown(variable), why), allowed_matrix);
    return std::nullopt;
  };
  if (!head || head->rank != 2 || head->dims == nullptr) return refuse_it("is no matrix");
  if (head->isComplex != 0) return refuse_it("is complex");
  const std::size_t n = head->dims[0];
  if (n == 0 || n != head->dims[1]) return refuse_it(fmt::format("is {} x {}", n, head->dims[1]));
  if (n > model::ShaftMatrices::most_degrees_of_freedom)
    return refuse_it(fmt::format("has more than {} rows", model::ShaftMatrices::most_degrees_of_freedom));
  const Variable whole(Mat_VarRead(open.get(), variable.c_str()));
  if (!whole) return refuse_it("cannot be read");
  const auto rows = static_cast<Eigen::Index>(n);
  const auto matrix = whole->class_type == MAT_C_SPARSE ? sparse(*whole, rows) : full(*whole, rows);
  if (!matrix) return refuse_it("holds no real numbers, or breaks off");
  if (!matrix->allFinite()) return refuse_it("holds a number that is not finite");
  return matrix;
}

}  // namespace rubsweep::config::machine
