#include "fuzz/byte_source.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rubsweep::fuzz {

std::string ByteSource::number(double usual) {
  // Numbers at the limits of double are refused by the reader, so only few machines get one.
  const int kind = below(64);
  if (kind < 46) return fmt::format("{}", usual);
  // A factor of up to 4 in either direction; in the next case, up to 10^8.
  if (kind < 57) return fmt::format("{:.4g}", usual * std::exp2((next() - 128) / 64.0));
  if (kind < 62) return fmt::format("{:.4g}", usual * std::pow(10.0, (next() - 128) / 16.0));
  if (kind == 62) return one_of({"0", "1", "-1", "1e-6", "1e6", "90", "1e-12", "1e12"});
  return one_of({"1e300", "1e-300", "5e-324", "1.7e308", "1e100", "1e-100", "1e30", "1e-30", "-1e300"});
}

}  // namespace rubsweep::fuzz
