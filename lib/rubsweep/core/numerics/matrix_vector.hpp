#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "rubsweep/core/numerics/aligned_matrix.hpp"

namespace rubsweep::numerics {

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
