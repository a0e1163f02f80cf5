#pragma once

#include <vector>

#include "rubsweep/analysis/linear/campbell.hpp"

namespace rubsweep::linear {

/// Shaft speed W at which two whirl modes can lock to each other through a bouncing contact (Shaw, Champneys
/// and Friswell, Proc. R. Soc. A 472, 2016, 20160303). Whirl frequencies w are positive forward and negative
/// backward; in the rotating frame they are w - W. The modes lock where p (w_first - W) = q (w_second - W),
/// that is, W = (p w_first - q w_second) / (p - q): one mode then whirls p times and the other q times until
/// both touch the wall again with the same place of the shaft.
struct LockSpeed {
  int first = 0, second = 0;  ///< numbers of the modes
  int p = 0, q = 0;
  double speed_hz = 0;
};

/// Lock speeds within a diagram for all pairs of its first four modes and all coprime p > q from 1 to 3,
/// ascending. Modes with more than half of critical damping are left out, because they decay before both
/// modes meet the wall again. Frequencies between the speeds of the diagram come from monotone cubics.
std::vector<LockSpeed> lock_speeds(const Campbell& diagram);

}  // namespace rubsweep::linear
