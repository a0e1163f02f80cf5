#include "rubsweep/core/structure/assembly.hpp"

#include <cmath>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/cholesky.hpp"

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

void refuse_unusable(const Assembly& assembly) {
  const LinearSystem& system = assembly.system;
  bool finite = system.mass.allFinite() && system.damping.allFinite() && system.stiffness.allFinite() &&
                system.unbalance_kg.allFinite() && system.weight_kg.allFinite() &&
                assembly.gyroscopic.allFinite() && assembly.circulatory.allFinite() &&
                assembly.bow_n.allFinite() && assembly.second_n.allFinite() && assembly.static_n.allFinite();
  for (const Point& point : system.points) finite = finite && point.map.allFinite();
  for (const ImpulseTrain& train : assembly.impulses) finite = finite && train.impulse_ns.allFinite();
  if (!finite) {
    throw ConfigError(
        "rotor, stops: their numbers give a mass, damping or stiffness that is no finite number, allowed: "
        "less extreme "
        "ones");
  }
  // Each mass against its own size: a rotor of a tonne may have a casing of a gramme.
  const Eigen::VectorXd scale = system.mass.diagonal().cwiseSqrt().cwiseInverse();
  const numerics::dense::CholeskyFactors factor(scale.asDiagonal() * system.mass * scale.asDiagonal());
  if (!scale.allFinite() || !factor.positive_definite()) {
    throw ConfigError(
        "rotor, stops: their numbers leave a motion without mass, allowed: masses less far apart");
  }
}

}  // namespace rubsweep::structure
