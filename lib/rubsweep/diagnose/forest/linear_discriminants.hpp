#pragma once

#include <Eigen/Core>

#include "rubsweep/diagnose/forest/tree.hpp"

namespace rubsweep::diagnose::forest {

/// Linear discriminant functions of labelled samples (Fisher 1936): for every label the projection of the
/// features on the inverse of the covariance within the labels times their mean under this label. Features
/// count in units of their standard deviation, up to four of them. Where there are fewer than ten samples for
/// each feature there are none: they would separate these samples and no others.
class LinearDiscriminants {
 public:
  explicit LinearDiscriminants(const LabelledSamples& samples);

  /// Features, a row for each observation, and beside them the functions, a column for each label.
  Eigen::MatrixXd beside(const Eigen::MatrixXd& features) const;

 private:
  Eigen::MatrixXd standard(const Eigen::MatrixXd& features) const;

  Eigen::RowVectorXd middle_, deviation_;
  Eigen::MatrixXd axes_;  ///< a column for each label
};

}  // namespace rubsweep::diagnose::forest
