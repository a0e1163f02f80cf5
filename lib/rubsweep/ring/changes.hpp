#pragma once

#include <complex>
#include <span>
#include <vector>

#include "rubsweep/ring/assembly.hpp"

namespace rubsweep::ring {

/// Speed at which the signature changes.
struct Change {
  double speed_rad_per_s = 0;
  Signature before, after;
  std::complex<double> root;  ///< root that crosses or becomes double, in 1/s, with Im >= 0
  int evaluations = 0;        ///< number of computed spectra
};

struct ChangeOptions {
  bool polish = true;                  ///< false: only bisection
  double tolerance_rad_per_s = 1e-11;  ///< width at which bisection ends
};

/// Finds every change between neighbours of `speeds_rad_per_s` (ascending), to rounding. Bisection isolates
/// one elementary change, whose speed is then the root of a smooth function: det K where a root crosses zero,
/// the real part where a pair crosses the axis, (lambda_1 - lambda_2)^2 where two roots merge. The speeds at
/// which K is singular are added to the given ones. Neighbours with equal signatures are assumed to have no
/// change between them.
std::vector<Change> find_changes(const NormalForm& form, std::span<const double> speeds_rad_per_s,
                                 const ChangeOptions& options = {});

/// Finds the changes with known signatures at the given speeds.
std::vector<Change> find_changes(const NormalForm& form, std::span<const double> speeds_rad_per_s,
                                 std::span<const Signature> signatures, const ChangeOptions& options = {});

}  // namespace rubsweep::ring
