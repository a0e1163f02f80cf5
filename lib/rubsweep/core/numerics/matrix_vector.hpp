#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace rubsweep::numerics {

/// A matrix, column by column, that vectors are multiplied by again and again: every column begins with a
/// cache line, so that a processor which reads whole lines never has to read two for one.
class AlignedMatrix {
 public:
  AlignedMatrix() = default;
  /// Zeros.
  AlignedMatrix(Eigen::Index rows, Eigen::Index columns)
      : rows_(rows), columns_(columns), lines_(static_cast<std::size_t>(columns * lines_a_column())) {}
  explicit AlignedMatrix(const Eigen::MatrixXd& matrix) : AlignedMatrix(matrix.rows(), matrix.cols()) {
    for (Eigen::Index j = 0; j < columns_; ++j)
      Eigen::Map<Eigen::VectorXd>(data() + j * stride(), rows_) = matrix.col(j);
  }

  Eigen::Index rows() const { return rows_; }
  Eigen::Index cols() const { return columns_; }
  /// Distance between numbers of one row in neighbouring columns.
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

/// product = matrix . vector, the matrix column by column, each `stride` >= rows numbers behind the one
/// before. Every row is summed in the order of its columns, so that the bits are those of the plain loop
/// whatever the processor adds at once. Nothing may overlap; columns >= 1.
void multiply(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix, std::ptrdiff_t stride,
              const double* vector, double* product);

/// The same for a matrix of Eigen into another vector: by Eigen where sizes are known to the compiler, which
/// unrolls such loops, and by `multiply` where they are not.
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
