#include "rubsweep/maps/basin/low_discrepancy.hpp"

#include <array>

#include "rubsweep/core/error.hpp"

namespace rubsweep::basin {
namespace {

constexpr std::array<std::size_t, most_dimensions> primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29};

double mirrored(std::size_t number, std::size_t base) {
  double value = 0, place = 1;
  for (; number > 0; number /= base) {
    place /= static_cast<double>(base);
    value += place * static_cast<double>(number % base);
  }
  return value;
}

}  // namespace

std::vector<double> low_discrepancy_point(std::size_t index, std::size_t dimensions) {
  if (dimensions > primes.size()) throw ConfigError("a sample has more than 10 numbers");
  std::vector<double> point;
  for (std::size_t i = 0; i < dimensions; ++i) point.push_back(mirrored(index + 1, primes[i]));
  return point;
}

}  // namespace rubsweep::basin
