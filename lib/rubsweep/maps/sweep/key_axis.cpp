#include "rubsweep/maps/sweep/key_axis.hpp"

namespace rubsweep::sweep {

std::vector<KeyValue> keys_at(const KeyAxis& axis, double value) {
  std::vector<KeyValue> keys;
  for (std::size_t i = 0; i < axis.keys.size(); ++i) keys.push_back({axis.keys[i], axis.factors[i] * value});
  return keys;
}

}  // namespace rubsweep::sweep
