#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubsweep::structure {

/// A point of the structure where a force may act or a sensor measure: displacement (x, y) = map * q, in
/// metres. A force (fx, fy) at the point enters the equations as map^T (fx, fy).
struct Point {
  Eigen::Matrix<double, 2, Eigen::Dynamic> map;  ///< matrix, 2 x n
};

/// Linear system M q'' + C q' + K q = f(t) with n coordinates.
struct LinearSystem {
  Eigen::MatrixXd mass;           ///< n x n, positive definite
  Eigen::MatrixXd damping;        ///< n x n; gyroscopic terms are part of it
  Eigen::MatrixXd stiffness;      ///< n x n
  Eigen::VectorXcd unbalance_kg;  ///< n: an eccentricity e gives the force e w^2 Re(unbalance_kg e^{i w t})
  Eigen::VectorXd weight_kg;      ///< n: gravity g along -y gives the force g * weight_kg
  std::vector<Point> points;

  Eigen::Index coordinates() const { return mass.rows(); }
};

/// Impulses at a fixed ratio to the rotation: `multiple` per revolution. The time from the start of a run to
/// the first one is `phase_periods` of the interval between two impulses.
struct ImpulseTrain {
  Eigen::VectorXd impulse_ns;  ///< n: generalised impulse; the velocities jump by mass^-1 impulse
  double multiple = 0;         ///< impulses per revolution, > 0
  double phase_periods = 0;    ///< share of the interval, >= 0 and < 1
};

}  // namespace rubsweep::structure
