#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace rubsweep::numerics {

/// A matrix, stored by columns, that multiplies many vectors. Every column starts at a cache line, so that
/// the processor never has to read two lines for one register.
class AlignedMatrix {
 public:
  AlignedMatrix() = default;
  /// Zero matrix.
  AlignedMatrix(Eigen::Index rows, Eigen::Index columns)
      : rows_(rows), columns_(columns), lines_(static_cast<std::size_t>(columns * lines_a_column())) {}
  explicit AlignedMatrix(const Eigen::MatrixXd& matrix) : AlignedMatrix(matrix.rows(), matrix.cols()) {
    for (Eigen::Index j = 0; j < columns_; ++j)
      Eigen::Map<Eigen::VectorXd>(data() + j * stride(), rows_) = matrix.col(j);
  }

  Eigen::Index rows() const { return rows_; }
  Eigen::Index cols() const { return columns_; }
  /// Distance in memory between neighbouring entries of a row.
  Eigen::Index stride() const { return lines_a_column() * per_line; }
  auto diagonal() const {
    return Eigen::Map<const Eigen::VectorXd, Eigen::Unaligned, Eigen::InnerStride<>>(
        data(), std::min(rows_, columns_), Eigen::InnerStride<>(stride() + 1));
  }
  const double* data() const { return lines_.empty() ? nullptr : lines_.data()->data(); }
  double* data() { return lines_.empty() ? nullptr : lines_.data()->data(); }

 private:
  static constexpr Eigen::Index per_line = 8;
  struct alignas(64) Line : std::array<double, per_line> {};

  Eigen::Index lines_a_column() const { return (rows_ + per_line - 1) / per_line; }

  Eigen::Index rows_ = 0, columns_ = 0;
  std::vector<Line> lines_;
};

/// product = matrix . vector. The matrix is stored by columns; each column begins `stride` >= rows numbers
/// after the one before. Each row is summed in the order of its columns, so that the bits are those of the
/// plain loop on every processor. Arguments must not overlap; columns >= 1.
void multiply(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix, std::ptrdiff_t stride,
              const double* vector, double* product);

/// The same product for an Eigen matrix: by Eigen where sizes are known at compile time, so that loops are
/// unrolled, otherwise by `multiply`.
template <class Matrix, class Vector, class Product>
void put_product(const Matrix& matrix, const Vector& vector, Product& product) {
  if constexpr (Matrix::RowsAtCompileTime == Eigen::Dynamic) {
    product.resize(matrix.rows());
    multiply(matrix.rows(), matrix.cols(), matrix.data(), matrix.outerStride(), vector.data(),
             product.data());
  } else {
    product = matrix.lazyProduct(vector.matrix());
  }
}

template <class Vector, class Product>
void put_product(const AlignedMatrix& matrix, const Vector& vector, Product& product) {
  product.resize(matrix.rows());
  multiply(matrix.rows(), matrix.cols(), matrix.data(), matrix.stride(), vector.data(), product.data());
}

template <class Product, class Matrix, class Vector>
Product product_of(const Matrix& matrix, const Vector& vector) {
  Product product;
  put_product(matrix, vector, product);
  return product;
}

}  // namespace rubsweep::numerics
