#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/ring/changes.hpp"
#include "rubsweep/ring/normal_form.hpp"
#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// A speed known in closed form, beside those from the eigenvalues.
struct CriticalSpeed {
  std::string name;
  double closed_form_rad_per_s = 0;
  /// Empty: outside of the range of speeds, or nothing happens there.
  std::optional<double> numeric_rad_per_s;
};

/// Every closed form that holds for this system (see closed_forms.hpp), each with the nearest speed of its
/// kind that was found numerically within 1e-6 of it: singular K for divergence, `changes` (of the system
/// with its friction) for the others.
std::vector<CriticalSpeed> critical_speeds(const System& system, const std::vector<Change>& changes);

/// Every speed (rad/s, ascending, repeated ones repeatedly) at which K0 - Omega^2 K2 is singular: a root
/// lambda passes through zero. No scan: they are the roots of a generalised eigenvalue problem.
std::vector<double> divergence_speeds(const NormalForm& form);

}  // namespace rubsweep::ring
