#include "rubsweep/measurement/diagnose/random_stream.hpp"

#include <cmath>
#include <numbers>

#include "rubsweep/core/numerics/split_mix.hpp"

namespace rubsweep::diagnose {

using numerics::split_mix;

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t index, std::uint64_t purpose)
    : state_(split_mix(split_mix(split_mix(seed) + index) + purpose)) {}

std::uint64_t RandomStream::bits() {
  const std::uint64_t number = split_mix(state_);
  state_ += numerics::split_mix_increment;
  return number;
}

double RandomStream::uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

double RandomStream::normal() {
  if (has_waiting_) {
    has_waiting_ = false;
    return waiting_;
  }
  const double radius = std::sqrt(-2 * std::log(1 - uniform())), angle = 2 * std::numbers::pi * uniform();
  waiting_ = radius * std::sin(angle);
  has_waiting_ = true;
  return radius * std::cos(angle);
}

double value_at(const Spread& spread, double unit) {
  if (spread.low == spread.high || unit < spread.at_low) return spread.low;
  unit = (unit - spread.at_low) / (1 - spread.at_low);
  if (!spread.logarithmic) return spread.low + (spread.high - spread.low) * unit;
  return spread.low * std::pow(spread.high / spread.low, unit);
}

}  // namespace rubsweep::diagnose
