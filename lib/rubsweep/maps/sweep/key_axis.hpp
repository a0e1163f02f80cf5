#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::sweep {

/// A number under a key of the configuration, as `--set KEY=VALUE` would write it.
struct KeyValue {
  std::string key;  ///< dotted path, such as stops.0.friction.coefficient
  double value = 0;
};

/// An axis of a sweep over numbers of the configuration, in the units of their keys. At its i-th place each
/// key holds values[i] times its own factor.
struct KeyAxis {
  std::vector<std::string> keys;            ///< at least one
  std::vector<double> factors;              ///< one for each key
  std::vector<double> values;               ///< at least one, all different
  std::optional<batch::Spacing> spacing{};  ///< how they are written; empty where they are listed
};

/// Values of all keys of an axis at one of its values.
std::vector<KeyValue> keys_at(const KeyAxis& axis, double value);

}  // namespace rubsweep::sweep
