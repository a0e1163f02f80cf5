#include "rubsweep/diagnose/random_stream.hpp"

#include <cmath>
#include <numbers>

namespace rubsweep::diagnose {
namespace {

constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t index, std::uint64_t purpose)
    : state_(mixed(mixed(mixed(seed + golden) + index + golden) + purpose + golden)) {}

std::uint64_t RandomStream::bits() {
  state_ += golden;
  return mixed(state_);
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

}  // namespace rubsweep::diagnose
