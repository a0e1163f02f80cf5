#pragma once

#include <string>

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::report {

/// Lines about the matrices of a kit: their size, mass and nodes, and what of them is symmetric and what is
/// not.
std::string explain_matrices(const model::RotorKit& kit);

}  // namespace rubsweep::report
