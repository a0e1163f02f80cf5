#include "rubsweep/structure/assembly.hpp"

#include <cmath>

namespace rubsweep::structure {

void add_body(LinearSystem& system, Eigen::Index first, double mass_kg, double stiffness_n_per_m,
              double damping_ratio) {
  for (Eigen::Index i = first; i < first + 2; ++i) {
    system.mass(i, i) = mass_kg;
    system.stiffness(i, i) = stiffness_n_per_m;
    system.damping(i, i) = 2 * damping_ratio * std::sqrt(stiffness_n_per_m * mass_kg);
  }
  system.weight_kg(first + 1) = -mass_kg;
  Point point{Eigen::Matrix<double, 2, Eigen::Dynamic>::Zero(2, system.coordinates())};
  point.map(0, first) = 1;
  point.map(1, first + 1) = 1;
  system.points.push_back(std::move(point));
}

}  // namespace rubsweep::structure
