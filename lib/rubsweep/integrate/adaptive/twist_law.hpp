#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate::adaptive {

/// Terms that torsion adds to the right-hand side of a scene, scaled: lengths by L, time in radians of the
/// drive's rotation, the angle coordinate by L like all others. phi is the angle of the rotor, phi' its rate
/// (1 where it keeps up with the drive).
struct TwistLaw {
  Eigen::Index coordinate = 0;
  double length_m = 0;            ///< L: angle = L times the coordinate
  Eigen::VectorXcd unbalance;     ///< M^-1 U / L: accelerations Re(unbalance (phi'^2 - i phi'') e^{i phi})
  Eigen::VectorXcd lever;         ///< L U / J: phi'' loses Re(i lever e^{i phi}) . (u'' - weight)
  Eigen::VectorXcd bow;           ///< M^-1 b / (L speed^2): accelerations Re(bow e^{i phi}); empty: none
  Eigen::VectorXcd bow_lever;     ///< L b / (J speed^2): phi'' gains Re(i bow_lever e^{i phi}) . u
  Eigen::MatrixXd gyroscopic;     ///< M^-1 G: accelerations -(phi' - 1) gyroscopic u'; empty: none
  Eigen::MatrixXd circulatory;    ///< M^-1 C / speed: accelerations -(phi' - 1) circulatory u; empty: none
  double inertia_share = 1;       ///< polar inertia without the eccentric masses / J, which has them
  double angle_per_nm = 0;        ///< 1 / (J speed^2): phi'' per newton metre
  double drive_stiffness_nm = 0;  ///< torque per radian of twist
  double drive_damping_nm = 0;    ///< torque per unit of the twist's rate
  std::vector<double> contact_radius_m;
};

/// Law of a scene that has torsion.
TwistLaw twist_law(const scene::Scene& scene);

/// The scene without the forces that turn with the shaft, which the law of torsion has.
scene::Scene without_turning(scene::Scene scene);

}  // namespace rubsweep::integrate::adaptive
