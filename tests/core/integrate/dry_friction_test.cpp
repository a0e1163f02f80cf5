// Dry friction, which is set-valued at zero slip: closed forms of sliding, sticking and reversing, Taylor
// pieces compared with Odeint with located events, and derivatives across stops and releases compared with
// differences.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "core/integrate/largest_difference.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/rolling_scene.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using std::numbers::pi;

run::SolverOptions stepper(run::Stepper which, double tolerance) {
  run::SolverOptions options;
  options.method = run::Method::adaptive;
  options.stepper = which;
  options.relative_tolerance = tolerance;
  return options;
}

/// Unit mass on a unit spring along y, pressed by N onto a wall across x with a moving surface: slip = y' +
/// V. Friction on the mass is -mu N for positive slip. A revolution lasts `revolution` seconds.
struct Belt {
  double normal = 2, mu = 0.25, damping = 0, surface = 0, revolution = 1;

  scene::Scene scene(double y, double rate) const {
    auto scene = test::one_mass_scene(1, 1, 0, revolution, 1);
    scene.structure.stiffness(0, 0) = 0;
    scene.structure.damping(1, 1) = damping;
    scene.constant_n << normal, 0;
    scene::Contact wall = test::wall_across_x(1, 1, 100, 0);
    wall.friction = model::ConstantFriction{mu};
    wall.surface_speed_m_per_s = surface;
    scene.contacts.push_back(wall);
    scene.displacement_m << 1 + normal / 100, y;
    scene.velocity_m_per_s << 0, rate;
    return scene;
  }
};

/// Position y and velocity y' after `turns` revolutions.
std::pair<double, double> after(const scene::Scene& scene, const run::SolverOptions& options, int turns,
                                run::TurnReport& report) {
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, options, modes);
  for (int k = 0; k < turns; ++k) EXPECT_EQ(run.advance({}, report), run::Outcome::ok);
  return {report.section[1], report.section[3] * scene.speed_rad_per_s};
}

TEST(DryFriction, AFreeVibrationLosesTheSameAmplitudeInEveryHalfPeriodAndThenSticks) {
  // Each half period loses 2 mu N / k = 1: from 2.2 to -1.2 to 0.2, where the spring is weaker than friction.
  const Belt belt{.revolution = pi / 2};
  run::TurnReport report;
  const auto taylor = after(belt.scene(2.2, 0), {}, 3, report);
  EXPECT_NEAR(taylor.first, -0.5, 1e-14);  // a quarter period after -1.2, at the centre -mu N
  EXPECT_GT(report.effort.taylor_turns, 0);
  EXPECT_EQ(report.effort.adaptive_turns, 0);
  for (const int turns : {4, 5, 40}) {
    const auto stuck = after(belt.scene(2.2, 0), {}, turns, report);
    EXPECT_NEAR(stuck.first, 0.2, 2e-14) << turns;
    EXPECT_NEAR(stuck.second, 0, 1e-14) << turns;
  }
  for (const auto which : {run::Stepper::rkf78, run::Stepper::dopri5, run::Stepper::rosenbrock4}) {
    const auto stuck = after(belt.scene(2.2, 0), stepper(which, 1e-10), 5, report);
    EXPECT_NEAR(stuck.first, 0.2, 1e-7);
    EXPECT_NEAR(stuck.second, 0, 1e-9);
  }
}

TEST(DryFriction, ABeltCarriesTheMassUntilTheSpringIsAsStrongAsFriction) {
  // The belt carries the mass at -V from y = 0 to k y = -mu N. Then it swings freely about that place with
  // damping, from speed -V, and does not reach the belt's speed again.
  const double v = 0.8, damping = 0.1, limit = 0.5;
  const Belt belt{.damping = damping, .surface = v, .revolution = 1};
  // With damping, the belt must supply -k y + c V: the mass slips from y = -(mu N - c V) on.
  const double let_go = -(limit - damping * v), leaves = -let_go / v;
  const double decay = damping / 2, rate = std::sqrt(1 - decay * decay);
  const auto slid = [&](double t) {
    const double from = let_go + limit, s = t - leaves;  // displacement from the centre at about -mu N
    const double b = (-v + decay * from) / rate;
    const double e = std::exp(-decay * s), cosine = std::cos(rate * s), sine = std::sin(rate * s);
    return std::pair{-limit + e * (from * cosine + b * sine),
                     e * ((rate * b - decay * from) * cosine - (rate * from + decay * b) * sine)};
  };
  ASSERT_LT(leaves, 1);
  run::TurnReport report;
  for (int turns = 1; turns < 8; ++turns) {
    const auto found = after(belt.scene(0, -v), {}, turns, report);
    EXPECT_NEAR(found.first, slid(turns).first, 1e-13) << turns;
    EXPECT_NEAR(found.second, slid(turns).second, 1e-13) << turns;
    const auto by_stepper = after(belt.scene(0, -v), stepper(run::Stepper::rkf78, 1e-12), turns, report);
    EXPECT_NEAR(by_stepper.first, slid(turns).first, 1e-9) << turns;
  }
}

TEST(DryFriction, TanhFrictionComesNearerAsOneOverItsSteepness) {
  const Belt belt{.damping = 0.1, .surface = 0.8, .revolution = 3};
  run::TurnReport report;
  const double exact = after(belt.scene(1.5, 2.0), {}, 3, report).first;
  EXPECT_GT(report.effort.switches, 0);
  double last = 0;
  for (const double steepness : {1e2, 1e3, 1e4}) {
    scene::Scene scene = belt.scene(1.5, 2.0);
    scene.contacts[0].friction = model::StribeckFriction{{0, 0, 0, belt.mu, steepness, 0}};
    const double error =
        std::abs(after(scene, stepper(run::Stepper::automatic, 1e-11), 3, report).first - exact);
    if (last > 0) {
      EXPECT_GT(last / error, 7) << steepness;
      EXPECT_LT(last / error, 14) << steepness;
    }
    last = error;
  }
  EXPECT_LT(last, 1e-3);
}

TEST(DryFriction, ASlipThatComesToZeroInTheFirstStepOfARunSticks) {
  const Belt belt{.surface = 0.5, .revolution = 1};
  for (const double slip : {1e-9, -1e-9, 1e-6}) {
    run::TurnReport report;
    const auto found =
        after(belt.scene(0.1, slip - belt.surface), stepper(run::Stepper::dopri5, 1e-8), 1, report);
    EXPECT_NEAR(found.second, -belt.surface, 1e-12) << slip;
  }
}

/// `contact` split into two parallel ones with shares of its stiffness and different friction coefficients,
/// which together act like the original one.
std::pair<scene::Contact, scene::Contact> split(const scene::Contact& contact, double share, double more) {
  const double mu = contact::dry_coefficient(contact.friction);
  std::pair parts(contact, contact);
  parts.first.stiffness_n_per_m *= share;
  parts.first.damping_ns_per_m *= share;
  parts.second.stiffness_n_per_m *= 1 - share;
  parts.second.damping_ns_per_m *= 1 - share;
  parts.first.friction = model::ConstantFriction{mu * more};
  parts.second.friction = model::ConstantFriction{mu * (1 - share * more) / (1 - share)};
  return parts;
}

/// Largest difference of the sections, over `turns`, between `scene` and the same scene with its first stop
/// split in two.
double split_apart(const scene::Scene& scene, const std::pair<scene::Contact, scene::Contact>& parts,
                   const run::SolverOptions& options, int turns) {
  scene::Scene two = scene;
  two.contacts[0] = parts.first;
  two.contacts.push_back(parts.second);
  exact::modes::ModeCache modes;
  const run::Run one_run = start(scene, options, modes), two_run = start(two, options, modes);
  run::TurnReport a, b;
  double apart = 0;
  for (int k = 0; k < turns; ++k) {
    EXPECT_EQ(one_run.advance({}, a), run::Outcome::ok) << k;
    EXPECT_EQ(two_run.advance({}, b), run::Outcome::ok) << k;
    apart = std::max(apart, largest_difference(a.section, b.section));
  }
  return apart;
}

TEST(DryFriction, TwoWallsOfOneRigidCasingHoldWhatOneDoes) {
  // The friction of each of the two walls is not unique, but the motion of the mass is.
  const Belt carried{.damping = 0.1, .surface = 0.8, .revolution = 1};
  const Belt stops{.normal = 2, .mu = 0.25, .revolution = pi / 2};
  for (const double share : {0.5, 0.2, 0.9}) {
    for (const double more : {1.0, 0.3, 1.05}) {
      for (const scene::Scene& scene :
           {carried.scene(0, -0.8), stops.scene(2.2, 0), carried.scene(1.5, 2.0)}) {
        const auto parts = split(scene.contacts[0], share, more);
        EXPECT_LT(split_apart(scene, parts, {}, 8), 1e-10) << share << ' ' << more;
        EXPECT_LT(split_apart(scene, parts, stepper(run::Stepper::dopri5, 1e-9), 8), 1e-6);
      }
    }
  }
}

TEST(DryFriction, PublishedWearPowerOfCoulombSliding) {
  // code_aster SDND104: N = 10, mu = 0.1, A = 1.5: N mean|v| = 0.409062.
  auto scene = test::one_mass_scene(1, 0, 0, 1, 1e-2);
  scene.harmonic_n << 0, std::complex<double>(0, -1.5);
  scene.constant_n << 10, 0;
  scene::Contact wall = test::wall_across_x(1, 1e-3, 1e6, 0);
  wall.friction = model::ConstantFriction{0.1};
  scene.contacts.push_back(wall);
  scene.displacement_m << 1e-3 + 1e-5, 0;
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  run::TurnRequest asked;
  asked.samples_per_revolution = 4000;
  run::TurnReport turn;
  for (int k = 0; k < 6; ++k) ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
  double sum = 0;
  for (int k = 0; k < turn.sample_count; ++k)
    sum += std::abs(turn.samples[4 * static_cast<std::size_t>(k) + 3]);
  EXPECT_NEAR(10 * sum / turn.sample_count * scene.length_scale_m * scene.speed_rad_per_s, 0.409062, 2e-6);
}

scene::Scene rolling(double surface_share = 1) {
  test::RollingScene rolling = test::rolling_scene(1e3);
  scene::Contact& stop = rolling.scene.contacts[0];
  stop.friction = model::ConstantFriction{0.2};
  stop.surface_speed_m_per_s = surface_share * rolling.radius * rolling.whirl;
  return rolling.scene;
}

TEST(DryFriction, RollingInAnAnnularStopKeepsItsClosedForm) {
  const auto closed = test::rolling_scene(1e3);
  exact::modes::ModeCache modes;
  const run::Run run = start(rolling(), {}, modes);
  run::TurnReport turn;
  for (int k = 1; k <= 50; ++k) {
    ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
    const std::complex<double> z(turn.section[0], turn.section[1]), v(turn.section[2], turn.section[3]);
    EXPECT_LT(std::abs(z - closed.displacement(k)), 2e-11) << k;
    EXPECT_LT(std::abs(v - closed.velocity(k)), 2e-11) << k;
  }
  EXPECT_EQ(turn.effort.switches, 0);
}

/// A rotor on two flat walls or in an annular stop, with dry friction and slow surfaces; the excitation makes
/// slips stop and reverse.
scene::Scene random_scene(std::mt19937& random, bool annular, int stops) {
  const auto even = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  // Drawn in separate statements, because compilers may evaluate arguments in any order.
  const double damping = even(0.02, 0.2), speed = even(0.8, 3);
  auto scene = test::one_mass_scene(1, 1, damping, 2 * pi / speed, 1);
  const double force = even(0.5, 3);
  scene.harmonic_n << force, std::complex<double>(0, -force);
  scene.constant_n << even(0, 0.5), even(-0.5, 0.5);
  for (int k = 0; k < stops; ++k) {
    scene::Contact stop;
    if (annular) {
      stop.wall = contact::AnnularWall{{even(-0.2, 0.2), even(-0.2, 0.2)}};
    } else {
      stop.wall = contact::FlatWall{contact::direction(even(0, 360))};
    }
    stop.clearance_m = even(0.8, 1.2);
    stop.stiffness_n_per_m = even(20, 200);
    stop.damping_ns_per_m = even(0, 3);
    stop.friction = model::ConstantFriction{even(0.1, 0.8)};
    stop.surface_speed_m_per_s = even(0, 1.5);
    scene.contacts.push_back(stop);
  }
  scene.displacement_m << even(-0.5, 0.5), even(-0.5, 0.5);
  scene.velocity_m_per_s << even(-2, 2), even(-2, 2);
  return scene;
}

TEST(DryFriction, StopsInTwoDoWhatTheyDoInOne) {
  std::mt19937 random(23);
  for (int cell = 0; cell < 60; ++cell) {
    const scene::Scene scene = random_scene(random, cell % 2 == 1, 1 + cell % 3 / 2);
    const auto parts = split(scene.contacts[0], 0.2 + 0.2 * (cell % 4), 0.4 + 0.2 * (cell % 3));
    EXPECT_LT(split_apart(scene, parts, {}, 6), 1e-7) << cell;
  }
}

TEST(DryFriction, NearlyParallelWallsDoNearlyWhatOneDoes) {
  for (const double apart_deg : {0.3, 0.01, 1e-4, 1e-6}) {
    // A rotor pressed onto the floor by its weight and kicked along it, with slow surfaces: it sticks and
    // slips.
    auto scene = test::one_mass_scene(1, 1, 0.05, 2 * pi / 0.15, 1);
    scene.harmonic_n << 0.2, std::complex<double>(0, -0.2);
    scene.constant_n << 0, -1.8;
    scene::Contact floor;
    floor.wall = contact::FlatWall{contact::direction(-90)};
    floor.clearance_m = 1;
    floor.stiffness_n_per_m = 1000;
    floor.damping_ns_per_m = 5;
    floor.friction = model::ConstantFriction{0.6};
    floor.surface_speed_m_per_s = 0.02;
    scene.contacts.push_back(floor);
    scene.displacement_m << 0.4, -1.0008;
    scene.velocity_m_per_s << 0.7, 0;
    auto parts = split(floor, 0.5, 1);
    parts.first.wall = contact::FlatWall{contact::direction(-90 - apart_deg)};
    parts.second.wall = contact::FlatWall{contact::direction(-90 + apart_deg)};
    // The penetrations of both walls differ by the angle times the displacement along the floor.
    const double angle = apart_deg * pi / 180;
    EXPECT_LT(split_apart(scene, parts, {}, 4), 4 * angle + 1e-9) << apart_deg;
    EXPECT_LT(split_apart(scene, parts, stepper(run::Stepper::dopri5, 1e-9), 1), 4 * angle + 1e-6)
        << apart_deg;
  }
}

TEST(DryFriction, AWallWhoseTangentTheRingsPassesLetsTheRunGoOn) {
  // The rotor rolls in a ring past a flat wall at the same distance: both slips are zero where the tangents
  // are parallel.
  for (const double share : {0.5, 0.8, 1.0}) {
    test::RollingScene rolling = test::rolling_scene(1e3);
    scene::Contact& ring = rolling.scene.contacts[0];
    ring.friction = model::ConstantFriction{0.4};
    ring.surface_speed_m_per_s = rolling.radius * rolling.whirl;
    scene::Contact wall = ring;
    wall.wall = contact::FlatWall{contact::direction(70)};
    wall.stiffness_n_per_m *= share;
    rolling.scene.contacts.push_back(wall);
    exact::modes::ModeCache modes;
    const run::Run run = start(rolling.scene, {}, modes),
                   other = start(rolling.scene, stepper(run::Stepper::rkf78, 1e-12), modes);
    run::TurnReport a, b;
    for (int k = 0; k < 6; ++k) {
      ASSERT_EQ(run.advance({}, a), run::Outcome::ok) << k;
      ASSERT_EQ(other.advance({}, b), run::Outcome::ok) << k;
      EXPECT_LT(largest_difference(a.section, b.section), 1e-8) << k;
      other.restart(a.section);
    }
    EXPECT_GT(a.effort.switches, 6);
  }
}

class DryFrictionRandom : public testing::TestWithParam<std::pair<bool, int>> {};

TEST_P(DryFrictionRandom, TaylorPiecesAgreeWithOdeintAndTheirDerivativesWithDifferences) {
  const auto [annular, stops] = GetParam();
  std::mt19937 random(7);
  int stuck = 0, compared = 0, good = 0;
  for (int cell = 0; cell < 100; ++cell) {
    scene::Scene scene = random_scene(random, annular, stops);
    exact::modes::ModeCache modes;
    const run::Run run = start(scene, {}, modes),
                   other = start(scene, stepper(run::Stepper::rkf78, 1e-12), modes);
    run::TurnRequest asked;
    run::TurnReport a, b;
    std::vector<double> before{scene.displacement_m(0), scene.displacement_m(1),
                               scene.velocity_m_per_s(0) / scene.speed_rad_per_s,
                               scene.velocity_m_per_s(1) / scene.speed_rad_per_s};
    for (int k = 0; k < 6; ++k) {
      run.restart(before);
      other.restart(before);
      asked.tangent_vectors.setIdentity(4, 4);
      ASSERT_EQ(run.advance(asked, a), run::Outcome::ok);
      ASSERT_EQ(other.advance({}, b), run::Outcome::ok);
      EXPECT_LT(largest_difference(a.section, b.section), 2e-8) << "cell " << cell << " turn " << k;
      if (const Eigen::MatrixXd* moved = a.tangent_vectors.get()) {
        const Eigen::MatrixXd by_solver = *moved;
        stuck += std::abs(by_solver.determinant()) < 1e-9;  // a sticking contact reduces the rank
        asked.tangent_vectors.resize(4, 0);
        double worst = 0;
        for (Eigen::Index j = 0; j < 4; ++j) {
          run::TurnReport up, down;
          std::vector<double> x = before;
          const auto i = static_cast<std::size_t>(j);
          constexpr double d = 1e-7;
          x[i] = before[i] + d;
          run.restart(x);
          ASSERT_EQ(run.advance(asked, up), run::Outcome::ok);
          x[i] = before[i] - d;
          run.restart(x);
          ASSERT_EQ(run.advance(asked, down), run::Outcome::ok);
          for (Eigen::Index r = 0; r < 4; ++r) {
            const auto place = static_cast<std::size_t>(r);
            const double difference = (up.section[place] - down.section[place]) / (2 * d);
            worst = std::max(worst, std::abs(difference - by_solver(r, j)) / (1 + by_solver.norm()));
          }
        }
        ++compared;
        good += worst < 1e-4;
      }
      before = a.section;
    }
  }
  EXPECT_GT(stuck, 150);
  EXPECT_GT(compared, 150);
  // Differences across a grazing contact are not derivatives.
  EXPECT_GE(good, compared - compared / 25) << compared;
}

INSTANTIATE_TEST_SUITE_P(Stops, DryFrictionRandom,
                         testing::Values(std::pair{false, 1}, std::pair{false, 2}, std::pair{true, 1}));

TEST(DryFriction, RollingHasTheDerivativeOfDifferences) {
  // The start is off the rolling motion, so the slip stops first; the rank drops there.
  scene::Scene scene = rolling(1.02);
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  run::TurnRequest asked;
  run::TurnReport turn, up, down;
  asked.tangent_vectors.setIdentity(4, 4);
  for (int k = 0; k < 3; ++k) ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
  ASSERT_NE(turn.tangent_vectors.get(), nullptr);
  std::vector<double> before{scene.displacement_m(0), 0, 0, scene.velocity_m_per_s(1)};
  run.restart(before);
  ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
  const Eigen::MatrixXd by_solver = *turn.tangent_vectors.get();
  asked.tangent_vectors.resize(4, 0);
  for (Eigen::Index j = 0; j < 4; ++j) {
    constexpr double d = 1e-6;
    std::vector<double> x = before;
    x[static_cast<std::size_t>(j)] += d;
    run.restart(x);
    ASSERT_EQ(run.advance(asked, up), run::Outcome::ok);
    x[static_cast<std::size_t>(j)] -= 2 * d;
    run.restart(x);
    ASSERT_EQ(run.advance(asked, down), run::Outcome::ok);
    for (Eigen::Index r = 0; r < 4; ++r) {
      const auto place = static_cast<std::size_t>(r);
      EXPECT_NEAR((up.section[place] - down.section[place]) / (2 * d), by_solver(r, j), 2e-6) << r << j;
    }
  }
  EXPECT_LT(std::abs(by_solver.determinant()), 1e-10);
}

}  // namespace
}  // namespace rubsweep::integrate
