#include "rubsweep/core/numerics/banded_system.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/lanes.hpp"

namespace rubsweep::numerics {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;

namespace {

/// Complex numbers column by column, with real and imaginary parts in separate arrays: a register then holds
/// as many parts as real numbers. A matrix with a narrow band keeps only the rows that elimination can reach.
struct SplitColumns {
  explicit SplitColumns(const MatrixXcd& matrix)
      : real(matrix.real()), imag(matrix.imag()), step(matrix.rows()) {}
  SplitColumns(Eigen::Index size, Eigen::Index band)
      : real(MatrixXd::Zero(std::min(size, 3 * band + 1), size)), imag(real), step(real.rows()) {
    if (step < size) first = 2 * band, --step;
  }
  MatrixXd real, imag;
  Eigen::Index first = 0, step;  ///< place of row 0 in column 0, and its distance to that in the next column
};

/// Part of a column.
struct SplitPart {
  double *real, *imag;

  SplitPart from(Eigen::Index row) const { return {real + row, imag + row}; }
  std::complex<double> at(Eigen::Index row) const { return {real[row], imag[row]}; }
  void put(Eigen::Index row, std::complex<double> value) const {
    real[row] = value.real();
    imag[row] = value.imag();
  }
  void swap(Eigen::Index i, Eigen::Index k) const {
    std::swap(real[i], real[k]);
    std::swap(imag[i], imag[k]);
  }
};

SplitPart column(SplitColumns& of, Eigen::Index k) {
  const Eigen::Index at = of.first + k * of.step;
  return {of.real.data() + at, of.imag.data() + at};
}

/// x -= factor y for the first `count` numbers.
template <std::size_t bytes>
[[gnu::always_inline]] inline void subtract(Eigen::Index count, std::complex<double> factor,
                                            const SplitPart& y, const SplitPart& x) {
  using Lane = typename Lanes<bytes>::Type;
  constexpr auto width = static_cast<Eigen::Index>(bytes / sizeof(double));
  const double real = factor.real(), imag = factor.imag();
  Eigen::Index i = 0;
  for (; i + width <= count; i += width) {
    Lane y_real, y_imag, x_real, x_imag;
    std::memcpy(&y_real, y.real + i, bytes);
    std::memcpy(&y_imag, y.imag + i, bytes);
    std::memcpy(&x_real, x.real + i, bytes);
    std::memcpy(&x_imag, x.imag + i, bytes);
    x_real -= y_real * real - y_imag * imag;
    x_imag -= y_real * imag + y_imag * real;
    std::memcpy(x.real + i, &x_real, bytes);
    std::memcpy(x.imag + i, &x_imag, bytes);
  }
  for (; i < count; ++i) {
    x.real[i] -= y.real[i] * real - y.imag[i] * imag;
    x.imag[i] -= y.real[i] * imag + y.imag[i] * real;
  }
}

/// Elimination within a band, column after column: pivoting and reduction of each column by all earlier
/// columns that reach it.
template <std::size_t bytes>
[[gnu::always_inline]] inline void eliminate(SplitColumns& a, SplitColumns& b, Eigen::Index band) {
  using Eigen::Index;
  const Index n = a.real.cols();
  std::vector<Index> pivots(static_cast<std::size_t>(n));
  const auto below = [&](Index k) { return std::min(band, n - 1 - k); };
  const auto reduce = [&](const SplitPart& x, Index first, Index last) __attribute__((always_inline)) {
    for (Index k = first; k < last; ++k) {
      x.swap(k, pivots[static_cast<std::size_t>(k)]);
      if (x.at(k) != 0.0) subtract<bytes>(below(k), x.at(k), column(a, k).from(k + 1), x.from(k + 1));
    }
  };
  for (Index k = 0; k < n; ++k) {
    const SplitPart x = column(a, k);
    reduce(x, std::max(Index{0}, k - 2 * band), k);
    Index pivot = k;
    for (Index i = k + 1; i <= k + below(k); ++i)
      if (std::norm(x.at(i)) > std::norm(x.at(pivot))) pivot = i;
    pivots[static_cast<std::size_t>(k)] = pivot;
    x.swap(k, pivot);
    const std::complex<double> inverse = 1.0 / x.at(k);
    for (Index i = k + 1; i <= k + below(k); ++i) {
      const double real = x.real[i], imag = x.imag[i];
      x.put(i,
            {real * inverse.real() - imag * inverse.imag(), real * inverse.imag() + imag * inverse.real()});
    }
  }
  for (Index j = 0; j < b.real.cols(); ++j) {
    const SplitPart x = column(b, j);
    reduce(x, 0, n);
    for (Index k = n - 1; k >= 0; --k) {
      x.put(k, x.at(k) / column(a, k).at(k));
      const Index first = std::max(Index{0}, k - 2 * band);
      subtract<bytes>(k - first, x.at(k), column(a, k).from(first), x.from(first));
    }
  }
}

}  // namespace

Eigen::Index band_of(std::initializer_list<const MatrixXd*> matrices) {
  Eigen::Index band = 0;
  for (const MatrixXd* matrix : matrices) {
    for (Eigen::Index k = 0; k < matrix->cols(); ++k) {
      for (Eigen::Index i = 0; i < matrix->rows(); ++i)
        if ((*matrix)(i, k) != 0) band = std::max(band, std::abs(i - k));
    }
  }
  return band;
}

MatrixXcd solve_banded(const std::function<std::complex<double>(Eigen::Index, Eigen::Index)>& entry,
                       MatrixXcd b, Eigen::Index band) {
  using Eigen::Index;
  const Index n = b.rows();
  // For larger matrices Eigen's blocks, which stay in the processor's cache, are faster.
  constexpr Index narrow = 6, small = 512;
  if (n > small && narrow * band > n) return dense::solve(MatrixXcd(MatrixXcd::NullaryExpr(n, n, entry)), b);
  SplitColumns factors(n, band), x(b);
  for (Index k = 0; k < n; ++k) {
    for (Index i = std::max(Index{0}, k - band); i <= std::min(n - 1, k + band); ++i)
      column(factors, k).put(i, entry(i, k));
  }
  in_widest_lanes(
      4, [&]<std::size_t bytes>() __attribute__((always_inline)) { eliminate<bytes>(factors, x, band); });
  b.real() = x.real;
  b.imag() = x.imag;
  return b;
}

}  // namespace rubsweep::numerics
