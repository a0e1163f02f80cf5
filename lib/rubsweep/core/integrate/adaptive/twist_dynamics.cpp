#include "rubsweep/core/integrate/adaptive/twist_dynamics.hpp"

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::integrate::adaptive {

TwistLaw twist_law(const scene::Scene& scene) {
  const scene::Twist& twist = *scene.twist;
  const run::StateScale scale = run::state_scale(scene);
  const numerics::dense::SymmetricFactors mass(scene.structure.mass);
  const auto solved = [&](const Eigen::VectorXcd& force) {
    Eigen::VectorXcd solution(force.size());
    solution.real() = mass.solve(Eigen::VectorXd(force.real()));
    solution.imag() = mass.solve(Eigen::VectorXd(force.imag()));
    return solution;
  };
  const double speed = scale.speed_rad_per_s, length = scale.length_m;
  const Eigen::Index c = twist.coordinate;
  const double inertia = scene.structure.mass(c, c) + twist.unbalance_inertia_kg_m2;
  TwistLaw law;
  law.coordinate = c;
  law.length_m = length;
  law.unbalance = solved(twist.unbalance_kg_m) / length;
  law.lever = twist.unbalance_kg_m * (length / inertia);
  if (twist.bow_n.size() > 0) {
    law.bow = solved(twist.bow_n) / scale.unit_acceleration_m_per_s2();
    law.bow_lever = twist.bow_n * (length / (inertia * speed * speed));
  }
  if (twist.gyroscopic.size() > 0) law.gyroscopic = mass.solve(twist.gyroscopic);
  if (twist.circulatory.size() > 0) law.circulatory = mass.solve(twist.circulatory) / speed;
  law.inertia_share = scene.structure.mass(c, c) / inertia;
  law.angle_per_nm = 1 / (inertia * speed * speed);
  law.drive_stiffness_nm = scene.structure.stiffness(c, c);
  law.drive_damping_nm = scene.structure.damping(c, c) * speed;
  law.contact_radius_m = twist.contact_radius_m;
  return law;
}

scene::Scene without_turning(scene::Scene scene) {
  scene.harmonic_n.setZero();
  return scene;
}

}  // namespace rubsweep::integrate::adaptive
