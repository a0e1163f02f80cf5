#include "ring/multiprecision.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_complex.hpp>
#include <cmath>

#include "ring/routh_hurwitz.hpp"
#include "rubsweep/ring/assembly.hpp"

namespace rubsweep::ring {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using Complex = boost::multiprecision::cpp_complex_50;

/// Rows of the state matrix, by Gauss-Jordan elimination with pivoting; time in units of 0.01 s.
template <class Number>
std::vector<Number> state_matrix_rows(const System& system, double speed) {
  const Matrices m = assemble(system);
  const auto n = static_cast<std::size_t>(m.coordinates());
  const Number w(speed), unit(100);
  // Column blocks: mass | -K | -C.
  std::vector<std::vector<Number>> rows(n, std::vector<Number>(3 * n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const auto r = static_cast<Eigen::Index>(i), c = static_cast<Eigen::Index>(j);
      rows[i][j] = Number(m.mass(r, c));
      rows[i][n + j] = (w * w * Number(m.softening(r, c)) - Number(m.stiffness(r, c))) / (unit * unit);
      rows[i][2 * n + j] = -w * Number(m.rotation(r, c)) / unit;
    }
  }
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t best = p;
    for (std::size_t i = p; i < n; ++i) {
      using std::abs;
      if (abs(rows[i][p]) > abs(rows[best][p])) best = i;
    }
    std::swap(rows[p], rows[best]);
    const Number pivot = rows[p][p];
    for (Number& entry : rows[p]) entry /= pivot;
    for (std::size_t i = 0; i < n; ++i) {
      const Number factor = rows[i][p];
      if (i == p) continue;
      for (std::size_t j = 0; j < 3 * n; ++j) rows[i][j] -= factor * rows[p][j];
    }
  }
  std::vector<Number> state(4 * n * n, Number(0));
  for (std::size_t i = 0; i < n; ++i) {
    state[i * 2 * n + n + i] = Number(1);
    for (std::size_t j = 0; j < 2 * n; ++j) state[(n + i) * 2 * n + j] = rows[i][n + j];
  }
  return state;
}

template <class Number>
std::vector<Number> polynomial(const System& system, double speed) {
  const auto size = 2 * static_cast<std::size_t>(assemble(system).coordinates());
  return characteristic_polynomial(state_matrix_rows<Number>(system, speed), size);
}

std::vector<Complex> roots(const System& system, double speed) {
  const std::vector<Real> coefficients = polynomial<Real>(system, speed);
  const std::size_t count = coefficients.size() - 1;
  std::vector<Complex> x;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 0.4 + 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    x.emplace_back(Real(1.3 * std::cos(angle)), Real(1.3 * std::sin(angle)));
  }
  for (int iteration = 0; iteration < 400; ++iteration) {
    Real largest(0);
    for (std::size_t i = 0; i < count; ++i) {
      Complex value(1), slope(0);
      for (std::size_t k = 1; k <= count; ++k) {
        slope = slope * x[i] + value;
        value = value * x[i] + coefficients[k];
      }
      if (value == Complex(0)) continue;
      Complex others(0);
      for (std::size_t k = 0; k < count; ++k) {
        if (k != i) others += Complex(1) / (x[i] - x[k]);
      }
      const Complex step = Complex(1) / (slope / value - others);
      x[i] -= step;
      largest = std::max(largest, Real(abs(step)));
    }
    if (largest < Real("1e-45")) break;
  }
  for (Complex& root : x) root *= 100;
  return x;
}

template <class Number>
int sign_changes(const System& system, double speed) {
  return routh_hurwitz_sign_changes(polynomial<Number>(system, speed)).value_or(-1);
}

}  // namespace

std::vector<std::complex<double>> roots_with_50_digits(const System& system, double speed_rad_per_s) {
  std::vector<std::complex<double>> result;
  for (const Complex& root : roots(system, speed_rad_per_s)) {
    result.emplace_back(root.real().convert_to<double>(), root.imag().convert_to<double>());
  }
  return result;
}

double discriminant_with_50_digits(const System& system, double speed_rad_per_s, std::complex<double> place) {
  std::vector<Complex> x = roots(system, speed_rad_per_s);
  const Complex target(place.real(), place.imag());
  std::sort(x.begin(), x.end(), [&](const Complex& a, const Complex& b) {
    return Real(abs(a - target)) < Real(abs(b - target));
  });
  const Complex difference = x[0] - x[1];
  return Complex(difference * difference).real().convert_to<double>();
}

int routh_hurwitz_with_50_digits(const System& system, double speed_rad_per_s) {
  return sign_changes<Real>(system, speed_rad_per_s);
}

int routh_hurwitz_with_long_double(const System& system, double speed_rad_per_s) {
  return sign_changes<long double>(system, speed_rad_per_s);
}

}  // namespace rubsweep::ring
