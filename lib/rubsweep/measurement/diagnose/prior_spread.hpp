#pragma once

namespace rubsweep::diagnose {

/// Knowledge of a number before a recording is looked at: it lies between two bounds, every part of the
/// interval being as likely, or every part of its logarithm. Equal bounds: it is known.
struct Spread {
  double low = 0, high = 0;  ///< low <= high; both > 0 where logarithmic
  bool logarithmic = false;
};

/// Value below which the number lies with probability `unit`, in [0, 1].
double value_at(const Spread& spread, double unit);

}  // namespace rubsweep::diagnose
