#include "rubsweep/analysis/branch/orbits/multiplier_columns.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>

#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::branch::orbits {
namespace {

constexpr Eigen::Index listed_multipliers = 2;

}  // namespace

std::string multiplier_columns() {
  std::string header;
  for (Eigen::Index i = 1; i <= listed_multipliers; ++i)
    header += fmt::format(",multiplier_{0}_re,multiplier_{0}_im", i);
  return header + ",floquet_modulus";
}

std::string multiplier_cells(const Eigen::VectorXcd& multipliers) {
  std::string cells;
  for (Eigen::Index i = 0; i < listed_multipliers; ++i) {
    if (i < multipliers.size()) {
      cells += fmt::format(",{},{}", batch::csv_number(multipliers(i).real()),
                           batch::csv_number(multipliers(i).imag()));
    } else {
      cells += ",,";
    }
  }
  return fmt::format("{},{}", cells, batch::csv_number(std::abs(multipliers(0))));
}

}  // namespace rubsweep::branch::orbits
