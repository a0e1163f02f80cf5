#pragma once

#include <map>
#include <string>
#include <string_view>

#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"

namespace rubsweep::config::machine {

/// Form of printed matrices: texts within the configuration, or names of the files that matrix_files returns.
enum class MatrixPrint { inside, as_files };
void print_shaft_matrices(yaml::Printer& printer, const model::ShaftMatrices& matrices, MatrixPrint how);

/// Files by name that MatrixPrint::as_files refers to: mass.mtx, stiffness.mtx, damping.mtx, gyroscopic.mtx,
/// degrees_of_freedom.csv and unbalance.csv.
std::map<std::string_view, std::string> matrix_files(const model::ShaftMatrices& matrices);

}  // namespace rubsweep::config::machine
