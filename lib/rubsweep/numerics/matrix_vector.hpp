#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace rubsweep::numerics {

/// product = matrix . vector, the matrix column by column and without gaps. Every row is summed in the order
/// of its columns, so that the bits are those of the plain loop whatever the processor adds at once.
/// Nothing may overlap; columns >= 1.
void multiply(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix, const double* vector,
              double* product);

/// The same as a vector of the type `Product`: by Eigen where sizes are known to the compiler, which unrolls
/// such loops, and by `multiply` where they are not.
template <class Product, class Matrix, class Vector>
Product product_of(const Matrix& matrix, const Vector& vector) {
  if constexpr (Matrix::RowsAtCompileTime == Eigen::Dynamic) {
    Product product(matrix.rows());
    multiply(matrix.rows(), matrix.cols(), matrix.data(), vector.data(), product.data());
    return product;
  } else {
    return matrix.lazyProduct(vector);
  }
}

}  // namespace rubsweep::numerics
