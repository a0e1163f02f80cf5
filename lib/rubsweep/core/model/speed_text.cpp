#include "rubsweep/core/model/speed_text.hpp"

#include <fmt/format.h>

namespace rubsweep::model {
namespace {

/// Text of a number rounded to `digits` digits, without an exponent: 12000, where "%.3g" gives 1.2e+04.
std::string rounded(double value, int digits) {
  return fmt::format("{}", std::stod(fmt::format("{:.{}g}", value, digits)));
}

}  // namespace

std::string speed_text(double speed_hz, int digits) {
  return fmt::format("{} Hz ({} rpm)", rounded(speed_hz, digits), rounded(rpm_per_hz * speed_hz, digits));
}

std::string speed_range_text(double from_hz, double to_hz, int digits) {
  return fmt::format("{} to {} Hz ({} to {} rpm)", rounded(from_hz, digits), rounded(to_hz, digits),
                     rounded(rpm_per_hz * from_hz, digits), rounded(rpm_per_hz * to_hz, digits));
}

}  // namespace rubsweep::model
