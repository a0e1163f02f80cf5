// Stops with nonlinear contact laws, and machines with such stops, for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <variant>
#include <vector>

#include "core/integrate/curved_reference.hpp"
#include "rubsweep/core/contact/curved_law.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::test_curved {

inline model::Stop stop_of(ForceCurve kind) {
  model::Stop stop;
  stop.clearance_m = 1e-3;
  stop.law.kind = kind;
  return stop;
}

inline model::Stop power_stop(double stiffness, double exponent, ImpactDamping damping = ImpactDamping::none,
                              double restitution = 1) {
  model::Stop stop = stop_of(ForceCurve::power);
  stop.law.stiffness_n_per_m_n = stiffness;
  stop.law.exponent = exponent;
  stop.law.damping = damping;
  stop.law.restitution = restitution;
  return stop;
}

inline void give_law(const model::Stop& stop, scene::Contact& contact) {
  contact.law = std::make_shared<contact::CurvedLaw>(stop);
  contact.stiffness_n_per_m = contact::secant_n_per_m(stop);
  contact.damping_ns_per_m = 0;
}

/// Root of the first integral by halving: (1 + e) x = ln((1 + x) / (1 - e x)).
inline double restitution_by_halving(double x) {
  Real low = 0, high = std::min<Real>(1, 1 / Real(x) * (1 - 1e-18L));
  for (int k = 0; k < 200; ++k) {
    const Real e = (low + high) / 2;
    ((1 + e) * x - std::log((1 + x) / (1 - e * x)) > 0 ? low : high) = e;
  }
  return double(low);
}

/// A rotor of 1 kg on springs, weight and a turning force, a casing of 0.3 kg behind the first stop.
inline scene::Scene rotor_and_casing(const std::vector<scene::Contact>& contacts, double force_n) {
  scene::Scene scene = test::one_mass_scene(1, 0, 0, 0.02, 1e-3);
  auto& system = scene.structure;
  Eigen::Vector4d mass(1, 1, 0.3, 0.3), stiffness(4e4, 5e4, 6e4, 6e4), damping(20, 25, 15, 15);
  system.mass = mass.asDiagonal();
  system.stiffness = stiffness.asDiagonal();
  system.damping = damping.asDiagonal();
  system.unbalance_kg = Eigen::VectorXcd::Zero(4);
  system.weight_kg = Eigen::Vector4d(0, -1, 0, 0);
  system.points.clear();
  Eigen::Matrix<double, 2, Eigen::Dynamic> rotor(2, 4), casing(2, 4);
  rotor << 1, 0, 0, 0, 0, 1, 0, 0;
  casing << 0, 0, 1, 0, 0, 0, 0, 1;
  system.points = {{rotor}, {casing}};
  scene.harmonic_n = Eigen::VectorXcd::Zero(4);
  scene.harmonic_n(0) = force_n;
  scene.harmonic_n(1) = {0, -force_n};
  scene.constant_n = Eigen::Vector4d(0, -9.81, 0, 0);
  scene.displacement_m = scene.velocity_m_per_s = Eigen::VectorXd::Zero(4);
  scene.velocity_m_per_s(1) = 0.3;
  scene.contacts = contacts;
  return scene;
}

inline double damping_of(ImpactDamping damping, double e) {
  switch (damping) {
    case ImpactDamping::none: return 0;
    case ImpactDamping::hunt_crossley: return 1.5 * (1 - e);
    case ImpactDamping::lankarani_nikravesh: return 0.75 * (1 - e * e);
    case ImpactDamping::flores: return 1.6 * (1 - e) / e;
    case ImpactDamping::delivered: {
      double low = 0, high = 1 / e;
      for (int k = 0; k < 100; ++k) {
        const double x = (low + high) / 2;
        (restitution_by_halving(x) > e ? low : high) = x;
      }
      return low;
    }
  }
  return 0;
}

class RandomMachine {
 public:
  explicit RandomMachine(unsigned seed) : random_(seed) {
    const int count = 1 + int(seed % 3);
    std::vector<scene::Contact> contacts;
    contacts.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i) contacts.push_back(contact(i == 0 && seed % 2 == 0, seed + unsigned(i)));
    scene = rotor_and_casing(contacts, between(10, 60));
  }

  scene::Scene scene;
  std::vector<model::Stop> stops;

  Reference reference() const {
    Reference reference{.scene = scene, .stops = stops};
    for (const model::Stop& stop : stops) {
      reference.x.push_back(damping_of(stop.law.damping, stop.law.restitution));
      reference.speed.push_back(stop.law.approach_speed_m_per_s.value_or(1));
    }
    for (Eigen::Index i = 0; i < 4; ++i) {
      reference.state[std::size_t(i)] = scene.displacement_m(i);
      reference.state[std::size_t(i) + 4] = scene.velocity_m_per_s(i);
    }
    return reference;
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  scene::Contact contact(bool moving, unsigned seed) {
    constexpr ForceCurve kinds[] = {ForceCurve::power, ForceCurve::power, ForceCurve::hertz_line,
                                    ForceCurve::table};
    model::Stop stop = stop_of(kinds[seed % 4]);
    model::NormalLaw& law = stop.law;
    law.exponent = std::array{1.5, between(1, 3), 1.2, 2.0}[seed / 4 % 4];
    law.stiffness_n_per_m_n = between(1e5, 1e6) / std::pow(5e-5, law.exponent - 1);
    law.penetration_m = {0, 3e-5, 1e-4};
    law.force_n = {0, between(1, 3), between(10, 60)};
    stop.hertz = model::HertzLine{.length_m = 0.02,
                                  .rotor = {0.02, between(2e8, 2e9), 0.3},
                                  .casing = {model::required, 1e9, 0.3},
                                  .casing_shape = model::HertzShape::flat,
                                  .design_force_n = 1};
    law.damping = model::impact_dampings.values[seed % 5];
    law.restitution = between(0.4, 1);
    if (seed % 7 == 0) law.approach_speed_m_per_s = between(0.05, 0.3);
    scene::Contact contact;
    contact.clearance_m = stop.clearance_m = between(3e-4, 6e-4);
    if (moving) contact.casing_point = 1;
    const double angle = between(0, 2 * std::numbers::pi);
    contact.wall = seed % 3 == 0 ? contact::Wall(contact::AnnularWall{})
                                 : contact::Wall(contact::FlatWall{{std::cos(angle), std::sin(angle)}});
    contact.surface_speed_m_per_s = 12;
    if (seed % 4 == 1) contact.friction = model::ConstantFriction{between(0, 0.3)};
    if (seed % 4 == 2) contact.friction = model::StribeckFriction{{0, 0, 0, between(0, 0.3), 0.1, 0}};
    give_law(stop, contact);
    stops.push_back(stop);
    return contact;
  }

  std::mt19937 random_;
};

inline double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace rubsweep::integrate::test_curved
