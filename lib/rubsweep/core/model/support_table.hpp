#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Coefficients of a support in the order of a table's columns: stiffness in N/m, damping in N s/m, mass in
/// kg. The force on the shaft is f_x = -(kxx x + kxy y + cxx x' + cxy y' + mxx x''), f_y with yx and yy.
inline constexpr std::array<std::string_view, 10> support_coefficients{"kxx", "kxy", "kyx", "kyy", "cxx",
                                                                       "cxy", "cyx", "cyy", "mxx", "myy"};

/// Coefficients of a support over the shaft speed. Between the given speeds they follow a monotone cubic
/// (numerics::Pchip); outside this range they are undefined.
struct SupportTable {
  std::vector<double> speed_hz;  ///< strictly ascending and > 0, but the first may be 0
  /// In the order of support_coefficients, each as long as speed_hz.
  std::array<std::vector<double>, support_coefficients.size()> columns;

  /// Smallest number of points that determines the curve between them.
  static constexpr std::size_t enough_points = 4;
  static constexpr std::size_t most_points = 2000;
};

Range range_of_column(std::size_t column);  ///< Allowed numbers of a column.

/// Throws ConfigError naming what is missing, out of range or out of order. `path` opens every message.
void validate(const SupportTable& table, const std::string& path);

}  // namespace rubsweep::model
