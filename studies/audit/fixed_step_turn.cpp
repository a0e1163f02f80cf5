#include "audit/fixed_step_turn.hpp"

#include <cmath>
#include <complex>

#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"

namespace rubsweep::audit {
namespace {

class Equations {
 public:
  explicit Equations(const scene::Scene& scene)
      : scene_(scene), inverse_mass_(numerics::dense::FullPivotFactors(scene.structure.mass).inverse()) {
    for (const scene::Contact& contact : scene.contacts)
      relative_.emplace_back(scene::relative_map(scene.structure, contact));
  }

  Eigen::VectorXd rate(const Eigen::VectorXd& state, double time_s) const {
    const Eigen::Index n = state.size() / 2;
    const Eigen::VectorXd q = state.head(n), v = state.tail(n);
    const double phase = scene_.speed_rad_per_s * time_s;
    Eigen::VectorXd force = scene_.constant_n - scene_.structure.stiffness * q -
                            scene_.structure.damping * v + std::cos(phase) * scene_.harmonic_n.real() -
                            std::sin(phase) * scene_.harmonic_n.imag();
    if (scene_.second_harmonic_n.size() > 0)
      force += (scene_.second_harmonic_n * std::polar(1.0, 2 * phase)).real();
    for (std::size_t i = 0; i < relative_.size(); ++i)
      force -= relative_[i].transpose() * on_casing(scene_.contacts[i], relative_[i] * q, relative_[i] * v);
    Eigen::VectorXd result(2 * n);
    result << v, inverse_mass_ * force;
    return result;
  }

 private:
  static Eigen::Vector2d on_casing(const scene::Contact& contact, Eigen::Vector2d d,
                                   const Eigen::Vector2d& v) {
    d += contact::offset(contact.wall);
    const Eigen::Vector2d normal = contact::normal_at(contact.wall, d);
    if (d.dot(normal) <= contact.clearance_m) return Eigen::Vector2d::Zero();
    const Eigen::Vector2d tangent(-normal.y(), normal.x());
    const auto force = contact::elastogap(contact.stiffness_n_per_m, contact.damping_ns_per_m,
                                          d.dot(normal) - contact.clearance_m, v.dot(normal));
    const double slip = v.dot(tangent) + contact.surface_speed_m_per_s;
    return force.total_n * normal +
           contact::friction_coefficient(contact.friction, slip) * force.spring_n * tangent;
  }

  const scene::Scene& scene_;
  Eigen::MatrixXd inverse_mass_;
  std::vector<Eigen::Matrix<double, 2, Eigen::Dynamic>> relative_;
};

}  // namespace

std::vector<double> fixed_step_turn(const scene::Scene& scene, const std::vector<double>& section,
                                    int steps) {
  const Equations equations(scene);
  const auto size = static_cast<Eigen::Index>(section.size());
  const double speed_unit = scene.length_scale_m * scene.speed_rad_per_s;
  Eigen::VectorXd scale = Eigen::VectorXd::Constant(size, scene.length_scale_m);
  scale.tail(size / 2).setConstant(speed_unit);
  Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(section.data(), size).cwiseProduct(scale);
  const double h = scene.period_s() / steps;
  for (int k = 0; k < steps; ++k) {
    const double t = h * k;
    const Eigen::VectorXd a = equations.rate(x, t), b = equations.rate(x + h / 2 * a, t + h / 2),
                          c = equations.rate(x + h / 2 * b, t + h / 2), d = equations.rate(x + h * c, t + h);
    x += h / 6 * (a + 2 * b + 2 * c + d);
  }
  const Eigen::VectorXd scaled = x.cwiseQuotient(scale);
  return {scaled.data(), scaled.data() + size};
}

}  // namespace rubsweep::audit
