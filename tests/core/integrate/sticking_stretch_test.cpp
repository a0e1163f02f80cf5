// Bodies held by dry friction at stiff flat walls and in stiff rings: closed forms and certified steps. They
// are compared with static equilibrium by hand, with Taylor pieces, with a stepper, and with fixed steps in
// polar coordinates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/integrate/largest_difference.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/integrate/taylor/taylor_run.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using std::numbers::pi;

/// Unit mass on unit springs along x and y, pressed onto a stiff damped wall across x with a possibly moving
/// surface; one revolution lasts 2 pi / `speed` seconds.
struct Held {
  double stiffness = 1e8, damping = 2e3, pressed_n = 2, mu = 0.5, surface = 0, speed = 1;
  double unbalance_n = 0, structure_damping = 0.05;

  scene::Scene scene(double y, double rate) const {
    auto scene = test::one_mass_scene(1, 1, structure_damping, 2 * pi / speed, 1);
    scene.constant_n << pressed_n + 1, 0;
    scene.harmonic_n << unbalance_n, std::complex<double>(0, -unbalance_n);
    scene::Contact wall = test::wall_across_x(1, 1, stiffness, damping);
    wall.friction = model::ConstantFriction{mu};
    wall.surface_speed_m_per_s = surface;
    scene.contacts.push_back(wall);
    scene.displacement_m << 1 + pressed_n / stiffness, y;
    scene.velocity_m_per_s << 0, rate;
    return scene;
  }
};

TEST(StickingStretch, ABodyHeldByFrictionCostsWhatOneAtRestDoes) {
  const Held held{.speed = 0.1};
  exact::modes::ModeCache modes;
  const run::Run run = start(held.scene(0.7, 0), {}, modes);
  run::TurnRequest asked{.samples_per_revolution = 16, .peaks = true};
  run::TurnReport turn;
  for (int k = 0; k < 20; ++k) {
    ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
    EXPECT_NEAR(turn.section[1], 0.7, 1e-14);
    EXPECT_NEAR(turn.section[3], 0, 1e-15);
    EXPECT_NEAR(turn.contact_fraction, 1, 1e-12);
    EXPECT_NEAR(turn.peak_contact_force_n, held.pressed_n, 1e-7);
    ASSERT_EQ(turn.sample_count, 16);
    for (std::size_t s = 0; s < 16; ++s) EXPECT_NEAR(turn.samples[4 * s + 1], 0.7, 1e-14);
  }
  // The wall's vibration has a phase of 6e5 radians in each of these revolutions.
  EXPECT_LT(turn.effort.steps, 20 * 10);
}

/// Compares turns of the run from `start` with Taylor pieces alone, for N coordinates.
template <int N = 2>
void expect_like_pieces(const scene::Scene& scene, int turns, double tolerance, long most_steps) {
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  taylor::TaylorRun<N> pieces(scene, {});
  run::TurnRequest asked{.samples_per_revolution = 32, .peaks = true};
  run::TurnReport a, b;
  for (int k = 0; k < turns; ++k) {
    asked.tangent_vectors = Eigen::MatrixXd::Identity(2 * N, 2 * N);
    ASSERT_EQ(run.advance(asked, a), run::Outcome::ok);
    ASSERT_EQ(pieces.advance(asked, b), run::Outcome::ok);
    EXPECT_LT(largest_difference(a.section, b.section), tolerance) << k;
    EXPECT_LT(largest_difference(a.samples, b.samples), tolerance) << k;
    EXPECT_NEAR(a.peak_contact_force_n, b.peak_contact_force_n, 1e-6) << k;
    EXPECT_NEAR(a.peak_displacement_m, b.peak_displacement_m, 1e-8) << k;
    EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-12) << k;
    EXPECT_EQ(a.hits, b.hits);
    ASSERT_NE(a.tangent_vectors.get(), nullptr);
    // Each piece adds an error of 4e-12 of the vectors.
    const Eigen::MatrixXd &by_run = *a.tangent_vectors.get(), &by_pieces = *b.tangent_vectors.get();
    EXPECT_LT((by_run - by_pieces).norm(), 1e-7 * (1 + by_pieces.norm())) << k;
  }
  EXPECT_LT(a.effort.steps, most_steps);
  EXPECT_LT(a.effort.steps, b.effort.steps / 4);
}

TEST(StickingStretch, AHeldBodyThatUnbalancePressesMovesAsByTaylorPieces) {
  Held held{.stiffness = 1e6, .damping = 400, .unbalance_n = 0.3};
  expect_like_pieces(held.scene(0.4, 0), 5, 1e-11, 400);
}

TEST(StickingStretch, TwoWallsOfOneTangentHoldABodyAsByTaylorPieces) {
  // The two walls share a friction of 0.9 N in a way that is not unique: one is at its limit, the other one
  // sticks.
  const Held held{.stiffness = 1e6, .damping = 400, .mu = 0.8};
  scene::Scene scene = held.scene(0.9, 0);
  scene.contacts.push_back(scene.contacts[0]);
  scene.contacts[1].stiffness_n_per_m = 2e6;
  scene.displacement_m(0) = 1 + 2.0 / 3e6;
  expect_like_pieces(scene, 3, 1e-11, 100);
}

TEST(StickingStretch, ABeltCarriesTheBodyAsByTaylorPieces) {
  // The mass is released where the spring force exceeds mu N = 1: y = -1 after twenty seconds, in the fourth
  // turn.
  Held held{.stiffness = 1e6, .damping = 400, .surface = 0.05};
  expect_like_pieces(held.scene(0, -0.05), 3, 1e-11, 300);
}

TEST(StickingStretch, ABeltLetsTheBodyGoWhereTheSpringIsAsStrongAsFriction) {
  // With the damper force c V the belt releases the mass at y = -(mu N - c V), as a stepper confirms.
  const Held held{.stiffness = 1e6, .damping = 400, .surface = 0.05};
  exact::modes::ModeCache modes;
  run::SolverOptions tight;
  tight.method = run::Method::adaptive;
  tight.stepper = run::Stepper::dopri5;
  tight.relative_tolerance = 1e-10;
  const run::Run run = start(held.scene(0, -0.05), {}, modes),
                 stepper = start(held.scene(0, -0.05), tight, modes);
  run::TurnReport a, b;
  for (int k = 0; k < 4; ++k) {
    ASSERT_EQ(run.advance({}, a), run::Outcome::ok);
    ASSERT_EQ(stepper.advance({}, b), run::Outcome::ok);
    EXPECT_NEAR(a.section[1], b.section[1], 1e-7) << k;
    EXPECT_NEAR(a.section[3], b.section[3], 1e-7) << k;
    if (k < 3) {
      EXPECT_NEAR(a.section[1], -0.05 * 2 * pi * (k + 1), 1e-13) << k;
    }
  }
  EXPECT_GT(a.section[3], -0.05 + 1e-3);
}

TEST(StickingStretch, UndampedVibrationAgainstTheWallNeitherEndsNorIsLost) {
  // The mass is pressed by 2 N and hit: the load oscillates by a tenth, but friction holds. The springs of
  // wall and structure act in parallel, so the motion is a cosine of angular frequency sqrt(k + K) about the
  // static equilibrium.
  const Held held{.stiffness = 1e6, .damping = 0, .structure_damping = 0};
  scene::Scene scene = held.scene(0.4, 0);
  scene.displacement_m(0) += 2e-7;
  const double rate = std::sqrt(1 + held.stiffness),
               rest = (held.pressed_n + 1 + held.stiffness) / (1 + held.stiffness),
               amplitude = scene.displacement_m(0) - rest;
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  run::TurnReport turn;
  for (int k = 1; k <= 4; ++k) {
    ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
    const double angle = rate * 2 * pi * k;
    EXPECT_NEAR(turn.section[0], rest + amplitude * std::cos(angle), 1e-15 * k) << k;
    EXPECT_NEAR(turn.section[2], -amplitude * rate * std::sin(angle), 1e-12 * k) << k;
    EXPECT_NEAR(turn.section[1], 0.4, 1e-14) << k;
  }
  EXPECT_LT(turn.effort.steps, 200);
  // A phase of 6000 radians per turn, so rounding of the pieces accumulates.
  expect_like_pieces(scene, 2, 1e-9, 200);
}

/// Unit mass on unit springs in a stiff ring of radius 1 about `centre`, whose surface does not move. Forces
/// press it onto the ring at angle 0, and friction holds it nearby.
struct Ringed {
  double stiffness = 1e6, damping = 400, pressed_n = 2, mu = 0.5, unbalance_n = 0.3, structure_damping = 0.05;
  Eigen::Vector2d centre{0, 0};

  scene::Contact ring() const {
    scene::Contact ring = test::wall_across_x(1, 1, stiffness, damping);
    ring.wall = contact::AnnularWall{-centre};
    ring.friction = model::ConstantFriction{mu};
    return ring;
  }

  /// Unit vector from the centre at `angle`, and the position there at which the ring's force is `load_n`.
  static Eigen::Vector2d towards(double angle) { return {std::cos(angle), std::sin(angle)}; }
  Eigen::Vector2d place(double angle, double load_n) const {
    return centre + (1 + load_n / stiffness) * towards(angle);
  }

  scene::Scene scene(double angle) const {
    auto scene = test::one_mass_scene(1, 1, structure_damping, 2 * pi, 1);
    scene.constant_n = (pressed_n + 1) * towards(0) + centre;
    scene.harmonic_n << unbalance_n, std::complex<double>(0, -unbalance_n);
    scene.contacts.push_back(ring());
    scene.displacement_m = place(angle, pressed_n);
    return scene;
  }
};

TEST(StickingStretch, ARingThatHoldsABodyCostsWhatRestDoes) {
  const Ringed ringed{.stiffness = 1e8, .damping = 2e3, .unbalance_n = 0};
  exact::modes::ModeCache modes;
  const run::Run run = start(ringed.scene(0.3), {}, modes);
  run::TurnRequest asked{.samples_per_revolution = 16};
  run::TurnReport turn;
  // The mass loads the ring by the radial force 3 cos(0.3) - 1.
  const double load = 3 * std::cos(0.3) - 1;
  double held_at = 0;
  for (int k = 0; k < 20; ++k) {
    asked.peaks = k > 0;
    ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
    // Rounding in the first pieces gives a tangential ring force of 1e-8 N.
    const double angle = std::atan2(turn.section[1], turn.section[0]);
    EXPECT_NEAR(angle, k == 0 ? 0.3 : held_at, k == 0 ? 1e-10 : 1e-14) << k;
    held_at = angle;
    EXPECT_NEAR(std::hypot(turn.section[0], turn.section[1]), 1 + load / (ringed.stiffness + 1), 1e-13) << k;
    EXPECT_NEAR(turn.contact_fraction, 1, 1e-12);
    ASSERT_EQ(turn.sample_count, 16);
    if (k > 0) {
      EXPECT_NEAR(turn.peak_contact_force_n, load, 1e-6);
    }
  }
  // The ring's vibration has a phase of 6e4 radians per revolution; Taylor pieces would need 8000.
  EXPECT_LT(turn.effort.steps, 20 * 10);
}

TEST(StickingStretch, ARingHoldsABodyAsByTaylorPieces) {
  expect_like_pieces(Ringed{}.scene(0.1), 4, 1e-11, 200);
  expect_like_pieces(Ringed{.stiffness = 1e5, .damping = 20, .centre = {0.3, -0.2}}.scene(-0.2), 4, 1e-11,
                     200);
}

TEST(StickingStretch, ARingWithoutDampingHoldsABodyThatRingsAsByTaylorPieces) {
  scene::Scene scene = Ringed{.damping = 0, .structure_damping = 0, .centre = {-0.1, 0.4}}.scene(0.1);
  scene.displacement_m *= 1 + 2e-7;
  expect_like_pieces(scene, 2, 1e-9, 200);
}

TEST(StickingStretch, ARingOnACasingHoldsABodyAsByTaylorPieces) {
  const Ringed ringed{.stiffness = 1e5, .damping = 20, .centre = {0.2, 0.1}};
  scene::Scene one = ringed.scene(0.15), scene = one;
  scene.structure.mass = Eigen::Vector4d(1, 1, 0.2, 0.3).asDiagonal();
  scene.structure.stiffness = Eigen::Vector4d(1, 1, 40, 60).asDiagonal();
  scene.structure.stiffness(0, 1) = 0.1;
  scene.structure.stiffness(1, 0) = -0.1;
  scene.structure.damping = Eigen::Vector4d(0.05, 0.08, 2, 1).asDiagonal();
  scene.structure.unbalance_kg = Eigen::VectorXcd::Zero(4);
  scene.structure.weight_kg = Eigen::Vector4d(0, -1, 0, -0.3);
  scene.structure.points = {{Eigen::MatrixXd::Identity(2, 4)},
                            {Eigen::MatrixXd::Identity(4, 4).bottomRows(2)}};
  scene.contacts[0].casing_point = 1;
  const auto longer = [](auto& vector) {
    vector.conservativeResize(4);
    vector.tail(2).setZero();
  };
  longer(scene.harmonic_n);
  longer(scene.constant_n);
  longer(scene.displacement_m);
  longer(scene.velocity_m_per_s);
  expect_like_pieces<4>(scene, 4, 1e-11, 400);
}

TEST(StickingStretch, TwoRingsHoldTwoBodiesAsByTaylorPieces) {
  const Ringed first{.stiffness = 1e5, .damping = 20}, second{.stiffness = 3e5, .damping = 100, .mu = 0.7};
  scene::Scene scene = first.scene(0.1);
  const scene::Scene other = second.scene(-0.25);
  scene.structure.mass.setIdentity(4, 4);
  scene.structure.stiffness = 1.5 * Eigen::MatrixXd::Identity(4, 4);
  scene.structure.stiffness.topRightCorner(2, 2) = scene.structure.stiffness.bottomLeftCorner(2, 2) =
      -0.5 * Eigen::MatrixXd::Identity(2, 2);
  scene.structure.damping = 0.1 * Eigen::MatrixXd::Identity(4, 4);
  scene.structure.unbalance_kg = Eigen::VectorXcd::Zero(4);
  scene.structure.weight_kg = Eigen::Vector4d(0, -1, 0, -1);
  scene.structure.points = {{Eigen::MatrixXd::Identity(2, 4)},
                            {Eigen::MatrixXd::Identity(4, 4).bottomRows(2)}};
  scene.contacts.push_back(second.ring());
  scene.contacts[1].rotor_point = 1;
  const auto join = [](auto& vector, const auto& more) {
    vector.conservativeResize(4);
    vector.tail(2) = more;
  };
  join(scene.harmonic_n, other.harmonic_n);
  join(scene.constant_n, other.constant_n);
  join(scene.displacement_m, other.displacement_m);
  join(scene.velocity_m_per_s, other.velocity_m_per_s);
  expect_like_pieces<4>(scene, 4, 1e-11, 400);
}

/// Motion of a `Ringed` body in polar coordinates by Runge-Kutta steps of fixed length. Each step sticks or
/// slips throughout; where the slip reverses within a step, the body sticks if friction can hold it.
class PolarRing {
 public:
  PolarRing(const Ringed& ringed, double angle) : ringed_(ringed) {
    const Eigen::Vector2d from_centre = ringed.place(angle, ringed.pressed_n) - ringed.centre;
    state_ << from_centre.norm(), 0, angle, 0;
  }

  void advance_turn(int steps) {
    const double h = 2 * pi / steps;
    for (int k = 0; k < steps; ++k) {
      const double t = k * h;
      const double pull = tangential_n(t, state_), most = limit_n(state_);
      if (stands_ && std::abs(pull) > most) way_ = pull > 0 ? 1 : -1, stands_ = false, ++releases;
      const Eigen::Vector4d a = rate(t, state_), b = rate(t + h / 2, state_ + h / 2 * a),
                            c = rate(t + h / 2, state_ + h / 2 * b), d = rate(t + h, state_ + h * c);
      state_ += h / 6 * (a + 2 * b + 2 * c + d);
      stood_ += stands_;
      ++all_;
      if (stands_ || state_(3) * way_ > 0) continue;
      state_(3) = 0;
      stands_ = true;
    }
  }

  std::vector<double> section() const {
    const double r = state_(0), v = state_(1), s = r * state_(3);
    const Eigen::Vector2d n = Ringed::towards(state_(2)), t{-n.y(), n.x()}, u = ringed_.centre + r * n,
                          w = v * n + s * t;
    return {u.x(), u.y(), w.x(), w.y()};
  }
  double share_that_stands() const { return double(stood_) / double(all_); }
  int releases = 0;

 private:
  Eigen::Vector2d forces_n(double t, const Eigen::Vector4d& s) const {
    const Eigen::Vector2d n = Ringed::towards(s(2)), across{-n.y(), n.x()};
    const Eigen::Vector2d u = ringed_.centre + s(0) * n, v = s(1) * n + s(0) * s(3) * across;
    return (ringed_.pressed_n + 1) * Ringed::towards(0) + ringed_.centre +
           ringed_.unbalance_n * Ringed::towards(t) - u - ringed_.structure_damping * v;
  }
  double tangential_n(double t, const Eigen::Vector4d& s) const {
    return forces_n(t, s).dot(Eigen::Vector2d(-std::sin(s(2)), std::cos(s(2))));
  }
  double limit_n(const Eigen::Vector4d& s) const {
    return ringed_.mu * ringed_.stiffness * std::max(0.0, s(0) - 1);
  }
  Eigen::Vector4d rate(double t, const Eigen::Vector4d& s) const {
    const double spring = ringed_.stiffness * std::max(0.0, s(0) - 1),
                 normal = std::clamp(spring + ringed_.damping * s(1), 0.0, 2 * spring);
    const Eigen::Vector2d force = forces_n(t, s);
    const double along =
        force.dot(Eigen::Vector2d(-std::sin(s(2)), std::cos(s(2)))) - way_ * ringed_.mu * spring;
    return {s(1), force.dot(Ringed::towards(s(2))) - normal + s(0) * s(3) * s(3), s(3),
            stands_ ? 0 : (along - 2 * s(1) * s(3)) / s(0)};
  }

  Ringed ringed_;
  Eigen::Vector4d state_;
  bool stands_ = true;
  double way_ = 1;
  long stood_ = 0, all_ = 0;
};

TEST(StickingStretch, ARingHoldsABodyAndLetsItGoAsByFixedSteps) {
  for (const Ringed& ringed :
       {Ringed{.stiffness = 1e5, .damping = 60, .mu = 0.3, .unbalance_n = 0.8},
        Ringed{.stiffness = 2e5, .damping = 60, .mu = 0.4, .unbalance_n = 1.2, .centre = {0.2, -0.3}}}) {
    exact::modes::ModeCache modes;
    const run::Run run = start(ringed.scene(0.1), {}, modes);
    PolarRing steps(ringed, 0.1);
    run::TurnReport turn;
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
      steps.advance_turn(400'000);
      EXPECT_LT(largest_difference(turn.section, steps.section()), 1e-7) << k;
    }
    EXPECT_GT(steps.releases, 3);
    EXPECT_GT(steps.share_that_stands(), 0.2);
    // Some of the steps use closed forms.
    EXPECT_GT(turn.effort.steps, turn.effort.taylor_pieces);
  }
}

}  // namespace
}  // namespace rubsweep::integrate
