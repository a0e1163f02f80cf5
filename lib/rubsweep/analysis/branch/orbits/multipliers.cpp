#include "rubsweep/analysis/branch/orbits/multipliers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::branch::orbits {
namespace {

constexpr Eigen::Index listed_multipliers = 2;

using Complex = std::complex<double>;

template <class Visit>
void for_each_pair(const Eigen::VectorXcd& multipliers, const Visit& visit) {
  for (Eigen::Index i = 0; i < multipliers.size(); ++i)
    for (Eigen::Index j = i + 1; j < multipliers.size(); ++j) visit(multipliers(i), multipliers(j));
}

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

Eigen::VectorXcd multipliers_of(const Eigen::MatrixXd& monodromy) {
  Eigen::VectorXcd multipliers = numerics::dense::eigenvalues(monodromy);
  std::stable_sort(multipliers.begin(), multipliers.end(),
                   [](Complex a, Complex b) { return std::abs(a) > std::abs(b); });
  for (Eigen::Index i = 0; i + 1 < multipliers.size(); ++i) {
    if (multipliers(i).imag() < 0 && multipliers(i + 1) == std::conj(multipliers(i)))
      std::swap(multipliers(i), multipliers(i + 1));
  }
  return multipliers;
}

int count_outside(const Eigen::VectorXcd& multipliers) {
  return static_cast<int>(
      std::count_if(multipliers.begin(), multipliers.end(), [](Complex m) { return std::abs(m) > 1; }));
}

double doubling_test(const Eigen::VectorXcd& multipliers) {
  Complex product = 1;
  for (const Complex m : multipliers) product *= m + 1.0;
  return product.real();
}

double unit_test(const Eigen::VectorXcd& multipliers) { return doubling_test(-multipliers); }

double torus_test(const Eigen::VectorXcd& multipliers) {
  Complex product = 1;
  for_each_pair(multipliers, [&](Complex a, Complex b) { product *= a * b - 1.0; });
  return product.real();
}

bool nearest_pair_is_complex(const Eigen::VectorXcd& multipliers) {
  double nearest = std::numeric_limits<double>::infinity();
  bool complex = false;
  for_each_pair(multipliers, [&](Complex a, Complex b) {
    const double distance = std::abs(a * b - 1.0);
    if (distance >= nearest) return;
    nearest = distance;
    complex = a.imag() != 0 && b == std::conj(a);
  });
  return complex;
}

}  // namespace rubsweep::branch::orbits
