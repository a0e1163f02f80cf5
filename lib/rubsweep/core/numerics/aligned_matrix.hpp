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

}  // namespace rubsweep::numerics
