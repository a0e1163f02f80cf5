#pragma once

#include <complex>
#include <span>
#include <vector>

#include "rubsweep/ring/assembly.hpp"

namespace rubsweep::ring {

/// A speed at which the signature changes.
struct Change {
  double speed_rad_per_s = 0;
  Signature before, after;
  std::complex<double> root;  ///< 1/s: the root that crosses or doubles there, the one with Im >= 0
  int evaluations = 0;        ///< spectra it took
};

struct ChangeOptions {
  bool polish = true;                  ///< false: bisection alone
  double tolerance_rad_per_s = 1e-11;  ///< where bisection ends
};

/// Every change between neighbours of `speeds_rad_per_s` (ascending), to rounding: bisection down to one
/// elementary change, then a root of the function that is smooth there: det K where a root crosses zero, the
/// real part where a pair crosses the axis, (lambda_1 - lambda_2)^2 where two roots merge. The speeds
/// at which K is singular are sought beside the given ones. Neighbours with equal signatures are taken as
/// free of changes.
std::vector<Change> find_changes(const NormalForm& form, std::span<const double> speeds_rad_per_s,
                                 const ChangeOptions& options = {});

/// The same where the signatures are known already.
std::vector<Change> find_changes(const NormalForm& form, std::span<const double> speeds_rad_per_s,
                                 std::span<const Signature> signatures, const ChangeOptions& options = {});

}  // namespace rubsweep::ring
