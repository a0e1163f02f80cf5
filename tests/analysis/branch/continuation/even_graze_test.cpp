#include "rubsweep/analysis/branch/continuation/even_graze.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <random>
#include <vector>

#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "support/annular_scene.hpp"

namespace rubsweep::branch::continuation {
namespace {

using std::numbers::pi;

/// A rotor of unit mass and stiffness in a ring with unit clearance.
struct Rotor {
  double zeta = 0.05, unbalance = 0.3, ring = 4, mu = 0, ring_damping = 0, offset = 0;

  scene::Scene scene(double speed) const {
    scene::Scene scene = test::annular_scene(1, zeta, speed, unbalance, 0, ring, mu);
    scene.contacts.front().damping_ns_per_m = ring_damping;
    scene.contacts.front().wall = contact::AnnularWall{{offset, 0}};
    return scene;
  }

  /// Speed at which the quiet circle has the radius 1: |1 - W^2 + 2 i zeta W| = e W^2, a quadratic equation
  /// for W^2.
  double grazing_speed(bool upper) const {
    const double a = 1 - unbalance * unbalance, half_b = 2 * zeta * zeta - 1;
    return std::sqrt((-half_b + (upper ? 1 : -1) * std::sqrt(half_b * half_b - a)) / a);
  }

  /// Full annular rub z'' = -W^2 z: zero where |(1 + b - W^2) r - b + i (2 zeta W r + mu b (r - 1))| = e W^2.
  double rub_rest(double r, double w) const {
    const double u = w * w, spring = (1 + ring) * r - ring, friction = mu * ring * (r - 1);
    return std::hypot(spring - u * r, 2 * zeta * w * r + friction) - unbalance * u;
  }
  std::optional<double> rubbing_speed(double r, bool upper) const {
    const double middle = std::sqrt(1 + ring - ring / r);
    double low = upper ? middle : 0.01 * middle, high = upper ? 100 * middle : middle;
    if ((rub_rest(r, low) < 0) == (rub_rest(r, high) < 0)) return std::nullopt;
    for (int i = 0; i < 200; ++i) {
      const double at = (low + high) / 2;
      ((rub_rest(r, at) < 0) == (rub_rest(r, low) < 0) ? low : high) = at;
    }
    return (low + high) / 2;
  }
};

class EvenGrazeOf : public ::testing::Test {
 protected:
  orbits::OrbitProblem problem_of(const std::function<scene::Scene(double)>& family) {
    orbits::OrbitProblem problem = orbits::scene_orbits(
        [family](double speed) -> std::optional<scene::Scene> { return family(speed); }, 1, {}, modes_);
    problem.low = 0.2;
    problem.high = 4;
    return problem;
  }

  /// The whole branch of circles in contact, started from the closed form at radius `r`.
  std::optional<Branch> rub_of(const Rotor& rotor, double r) {
    const auto speed = rotor.rubbing_speed(r, false);
    if (!speed) return std::nullopt;
    const double w = *speed;
    const std::complex<double> needed((1 + rotor.ring - w * w) * r - rotor.ring,
                                      2 * rotor.zeta * w * r + rotor.mu * rotor.ring * (r - 1));
    scene::Scene scene = rotor.scene(w);
    const std::complex<double> z = r * std::polar(1.0, -std::arg(needed));
    test::start_at(scene, z, std::complex<double>(0, w) * z);
    const auto section = integrate::run::scaled_initial_state(scene);
    const orbits::OrbitProblem problem = problem_of([&](double at) { return rotor.scene(at); });
    const auto start = orbit_from(problem, Eigen::Map<const Eigen::VectorXd>(section.data(), 4), w);
    if (!start || !start->facts.touched) return std::nullopt;
    FollowOptions options;
    options.most_points = 400;
    return follow_both_ways(problem, *start, options);
  }

  integrate::exact::modes::ModeCache modes_;
};

std::vector<BranchEvent> grazes_of(const std::vector<BranchEvent>& events) {
  std::vector<BranchEvent> grazes;
  std::ranges::copy_if(events, std::back_inserter(grazes), [](const BranchEvent& event) {
    return event.kind == EventKind::graze || event.kind == EventKind::sequence;
  });
  return grazes;
}

TEST_F(EvenGrazeOf, FullAnnularRubIsOneGrazeWithAnErrorThatHolds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  int ends = 0;
  for (int machine = 0; machine < 8; ++machine) {
    Rotor rotor;
    rotor.zeta = 0.02 * std::pow(10, share(random));
    rotor.unbalance = 0.25 + 0.4 * share(random);
    rotor.ring = std::pow(10, 2.5 * share(random));
    rotor.mu = machine % 2 == 0 ? 0 : 0.1 * share(random);
    rotor.ring_damping = machine % 3 == 0 ? 0 : 0.3 * share(random);
    const auto branch = rub_of(rotor, 1.02);
    ASSERT_TRUE(branch) << machine;
    const auto grazes = grazes_of(branch->events);
    const std::size_t expected = branch->rising == Ending::off_the_walls ? 2 : 1;
    EXPECT_EQ(branch->falling, Ending::off_the_walls) << machine;
    EXPECT_NE(branch->rising, Ending::step_too_small) << machine;
    EXPECT_NE(branch->rising, Ending::singular) << machine;
    ASSERT_EQ(grazes.size(), expected) << machine;
    for (const BranchEvent& graze : grazes) {
      const bool upper = graze.point.parameter > 1;
      const double error = std::abs(graze.point.parameter - rotor.grazing_speed(upper));
      EXPECT_LE(error, graze.parameter_error) << machine << " " << graze.point.parameter;
      EXPECT_LT(graze.parameter_error, 1e-9) << machine;
      EXPECT_EQ(graze.detail, "contact all along at stop 0 disappears");
      EXPECT_FALSE(graze.point.facts.touched);
      EXPECT_NEAR(graze.point.facts.amplitude_m, 1, 1e-9);
      ++ends;
      EXPECT_LT(graze.parameter_error, 1e3 * std::max(error, 1e-15)) << machine;
    }
  }
  EXPECT_GT(ends, 8);
}

/// From the quiet circle through the corner into the rub, through a fold, and out of contact on the other
/// side.
TEST_F(EvenGrazeOf, TheQuietCircleGoesOnThroughTheGraze) {
  int appear = 0, disappear = 0;
  for (const double ring : {0.3, 4.0, 60.0}) {
    for (const double mu : {0.0, 0.05}) {
      const Rotor rotor{.zeta = 0.1, .unbalance = 0.35, .ring = ring, .mu = mu};
      const orbits::OrbitProblem problem = problem_of([&](double at) { return rotor.scene(at); });
      const auto start = orbit_from(problem, Eigen::VectorXd::Zero(4), 0.5);
      ASSERT_TRUE(start);
      FollowOptions options;
      options.most_points = 600;
      const HalfBranch half = follow(problem, *start, options);
      EXPECT_NE(half.ending, Ending::step_too_small) << ring << ' ' << mu;
      EXPECT_NE(half.ending, Ending::singular) << ring << ' ' << mu;
      const auto grazes = grazes_of(half.events);
      ASSERT_FALSE(grazes.empty()) << ring;
      ASSERT_LE(grazes.size(), 2u) << ring;
      for (std::size_t i = 0; i < grazes.size(); ++i) {
        const double error = std::abs(grazes[i].point.parameter - rotor.grazing_speed(i == 1));
        EXPECT_LE(error, grazes[i].parameter_error) << ring;
        EXPECT_LT(grazes[i].parameter_error, 1e-9) << ring;
        EXPECT_EQ(grazes[i].detail,
                  i == 0 ? "contact all along at stop 0 appears" : "contact all along at stop 0 disappears");
        ++(i == 0 ? appear : disappear);
      }
      for (const BranchPoint& point : half.points) {
        if (!point.facts.touched) continue;
        EXPECT_NEAR(rotor.rub_rest(point.facts.amplitude_m, point.parameter), 0, 1e-8) << ring;
      }
    }
  }
  EXPECT_EQ(appear, 6);
  EXPECT_GE(disappear, 2);
}

/// Rotor and casing whirl together in contact; the casing is at rest where they separate.
TEST_F(EvenGrazeOf, ACasingThatWhirlsAsWell) {
  const Rotor rotor{.zeta = 0.1, .unbalance = 0.35, .ring = 5, .mu = 0.05, .ring_damping = 0.2};
  const auto with_casing = [&](double speed) {
    constexpr double casing_mass = 0.4, casing_stiffness = 7, casing_damping = 0.6;
    scene::Scene scene = rotor.scene(speed);
    auto& system = scene.structure;
    const auto wider = [](const Eigen::MatrixXd& inner, double outer) {
      Eigen::MatrixXd all = outer * Eigen::MatrixXd::Identity(4, 4);
      all.topLeftCorner(2, 2) = inner;
      return all;
    };
    system.mass = wider(system.mass, casing_mass);
    system.stiffness = wider(system.stiffness, casing_stiffness);
    system.damping = wider(system.damping, casing_damping);
    system.unbalance_kg = Eigen::VectorXcd::Zero(4);
    system.weight_kg = Eigen::VectorXd::Zero(4);
    system.points.front().map = Eigen::MatrixXd::Identity(2, 4);
    system.points.push_back(system.points.front());
    system.points.back().map << 0, 0, 1, 0, 0, 0, 0, 1;
    scene.contacts.front().casing_point = 1;
    scene.harmonic_n.conservativeResizeLike(Eigen::VectorXcd::Zero(4));
    scene.constant_n = scene.displacement_m = scene.velocity_m_per_s = Eigen::VectorXd::Zero(4);
    return scene;
  };
  const orbits::OrbitProblem problem = problem_of(with_casing);
  const auto start = orbit_from(problem, Eigen::VectorXd::Zero(8), 0.5);
  ASSERT_TRUE(start);
  FollowOptions options;
  options.most_points = 400;
  const HalfBranch half = follow(problem, *start, options);
  const auto grazes = grazes_of(half.events);
  ASSERT_FALSE(grazes.empty());
  ASSERT_LE(grazes.size(), 2u);
  for (std::size_t i = 0; i < grazes.size(); ++i) {
    const double error = std::abs(grazes[i].point.parameter - rotor.grazing_speed(i == 1));
    EXPECT_LE(error, grazes[i].parameter_error);
    EXPECT_LT(grazes[i].parameter_error, 1e-9);
  }
}

/// A ring slightly off centre: the quiet circle of radius A begins to touch where A = 1 - offset. It touches
/// in a single impact, or everywhere at once if the offset is smaller than the resolution of orbits. The
/// error bound must also include the place where A = 1 - offset.
TEST_F(EvenGrazeOf, ARingJustOffTheCentre) {
  for (const double offset : {1e-12, 1e-10, 5e-9, 1e-7, 1e-5, 1e-3}) {
    const Rotor rotor{.zeta = 0.1, .unbalance = 0.35, .ring = 0.3, .offset = offset};
    const orbits::OrbitProblem problem = problem_of([&](double at) { return rotor.scene(at); });
    const auto start = orbit_from(problem, Eigen::VectorXd::Zero(4), 0.5);
    ASSERT_TRUE(start);
    FollowOptions options;
    options.most_points = 400;
    const HalfBranch half = follow(problem, *start, options);
    const auto grazes = grazes_of(half.events);
    ASSERT_FALSE(grazes.empty()) << offset;
    // The graze is at (1 - offset) |1 - W^2 + 2 i zeta W| = e W^2.
    Rotor nearer = rotor;
    nearer.unbalance /= 1 - offset;
    const double error = std::abs(grazes.front().point.parameter - nearer.grazing_speed(false));
    EXPECT_LE(error, grazes.front().parameter_error) << offset;
    EXPECT_LT(grazes.front().parameter_error, 1e-9 + offset) << offset;
  }
}

}  // namespace
}  // namespace rubsweep::branch::continuation
