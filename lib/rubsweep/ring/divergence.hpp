#pragma once

#include <vector>

#include "rubsweep/ring/normal_form.hpp"

namespace rubsweep::ring {

/// Every speed (rad/s, ascending, repeated ones repeatedly) at which K0 - Omega^2 K2 is singular: a root
/// lambda passes through zero. No scan: they are the roots of a generalised eigenvalue problem.
std::vector<double> divergence_speeds(const NormalForm& form);

}  // namespace rubsweep::ring
