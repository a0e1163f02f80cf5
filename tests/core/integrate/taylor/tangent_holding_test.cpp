#include "rubsweep/core/integrate/taylor/tangent_holding.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/annular_scene.hpp"

namespace rubsweep::integrate::taylor {
namespace {

constexpr int holding_order = 12;
using State = Eigen::Vector4d;

constexpr double angle_rad = 0.3;  ///< angle of the normal

/// A rotor that sticks to a wall by dry friction.
struct Sticking {
  explicit Sticking(bool annular) : scene(test::annular_scene(1, 0.1, 1.3, 0.2, 0, 10, 0.3)) {
    scene.contacts[0].friction = model::ConstantFriction{0.3};
    if (!annular) scene.contacts[0].wall = contact::FlatWall{{std::cos(angle_rad), std::sin(angle_rad)}};
    system = run::scale<2>(scene);
  }
  void expand(Expansion<2>& motion, const State& state) const {
    const run::PulseTimes no_pulses(scene, run::state_scale(scene), 2 * std::numbers::pi);
    motion.expand(state.data(), 0.3, no_pulses, {contact::Mode::sprung}, {contact::Slip::sticking});
  }

  scene::Scene scene;
  run::ScaledSystem<2> system;
};

/// Taylor coefficients of the friction that holds the rotor, starting from `state`.
std::array<double, holding_order> holding(const Sticking& rotor, const State& state) {
  Expansion<2> motion(rotor.system, {.order = holding_order});
  rotor.expand(motion, state);
  std::array<double, holding_order> force{};
  for (int k = 0; k < holding_order; ++k)
    force[static_cast<std::size_t>(k)] = motion.contact(0).holding().number(k);
  return force;
}

/// Change of the coefficients of `holding` by a small change of the motion, from an expansion of the simplest
/// kind.
std::array<double, holding_order> change_of_holding(const Sticking& rotor, const State& state,
                                                    const State& change) {
  Expansion<2> motion(rotor.system, {.order = holding_order + 1});
  rotor.expand(motion, state);
  const run::ScaledContact<2>& contact = rotor.system.contacts[0];
  std::vector<ContactTangents<1>> tangents(1);
  tangents[0].follow(motion.contact(0), motion.jacobian(0), holding_order);
  TangentHolding tested(1, holding_order + 1);
  Eigen::Vector2d w = change.head<2>(), rate = change.tail<2>();
  tangents[0].begin({at_contact(contact, w)});
  std::array<double, holding_order> force{};
  for (int k = 0; k < holding_order; ++k) {
    Eigen::Vector2d acceleration = -rotor.system.stiffness * w - rotor.system.damping * rate;
    const numerics::Twin push = tangents[0].force_term(k, {at_contact(contact, rate)})[0];
    acceleration += contact.first_push * push[0] + contact.second_push * push[1];
    tested.hold(motion, rotor.system, tangents, 0, k, acceleration.col(0));
    force[static_cast<std::size_t>(k)] = tested.term(k, 0);
    w = rate / (k + 1);
    rate = acceleration / (k + 1);
  }
  return force;
}

/// The sliding speed must be the same for all vectors, because a sticking contact prescribes it.
TEST(TangentHolding, IsTheDifferenceOfTwoMotions) {
  for (const bool annular : {false, true}) {
    const Sticking rotor(annular);
    const double radius = 1.2, inward = -0.4, sliding = annular ? 0.5 : 0.2;
    const Eigen::Rotation2D<double> to_rotor(angle_rad);
    // Components along normal and tangent: d1 d2' - d2 d1' = sliding |d| with d = (radius, 0).
    const Eigen::Vector2d moved(0.7, -0.6), speed(0.9, annular ? moved(1) * inward / radius : 0);
    State state, change;
    state << to_rotor * Eigen::Vector2d(radius, 0), to_rotor * Eigen::Vector2d(inward, sliding);
    change << to_rotor * moved, to_rotor * speed;
    constexpr double small = 1e-5;
    const auto later = holding(rotor, state + small * change),
               earlier = holding(rotor, state - small * change),
               derivative = change_of_holding(rotor, state, change);
    for (std::size_t k = 0; k < holding_order; ++k) {
      const double expected = (later[k] - earlier[k]) / (2 * small);
      EXPECT_NEAR(derivative[k], expected, 1e-7 * (1 + std::abs(expected))) << annular << ' ' << k;
    }
    EXPECT_GT(std::abs(derivative[0]), 1e-3);
  }
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
