// Static friction above sliding friction: closed forms of stick-slip on a belt and on a ramp, an independent
// reference in long double for one to three walls and a ring, Odeint, and differences for the derivatives.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <random>
#include <vector>

#include "core/integrate/largest_difference.hpp"
#include "core/integrate/stick_slip_reference.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using model::FallingFriction;
using model::StaticFriction;
using std::numbers::pi;

run::SolverOptions adaptive(run::Stepper which, double tolerance) {
  run::SolverOptions options;
  options.method = run::Method::adaptive;
  options.stepper = which;
  options.relative_tolerance = tolerance;
  return options;
}

/// Unit mass on a unit spring along y, pressed by N onto a wall across x, whose surface moves at V.
struct Belt {
  model::Friction friction = StaticFriction{0.6, 0.25};
  double normal = 2, damping = 0, surface = 0.3, revolution = 1;
  double spring = 1, along = 0;  ///< force along y

  scene::Scene scene(double y, double rate) const {
    auto scene = test::one_mass_scene(1, spring, 0, revolution, 1);
    scene.structure.stiffness(0, 0) = 0;
    scene.structure.damping(1, 1) = damping;
    scene.constant_n << normal, along;
    scene::Contact wall = test::wall_across_x(1, 1, 100, 0);
    wall.friction = friction;
    wall.surface_speed_m_per_s = surface;
    scene.contacts.push_back(wall);
    scene.displacement_m << 1 + normal / 100, y;
    scene.velocity_m_per_s << 0, rate;
    return scene;
  }
};

struct Motion {
  std::vector<std::pair<double, double>> states;  ///< y and y' after each turn
  run::TurnReport last;
};

Motion run_of(const scene::Scene& scene, const run::SolverOptions& options, int turns) {
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, options, modes);
  Motion motion;
  for (int k = 0; k < turns; ++k) {
    EXPECT_EQ(run.advance({}, motion.last), run::Outcome::ok) << k;
    motion.states.emplace_back(motion.last.section[1], motion.last.section[3] * scene.speed_rad_per_s);
  }
  return motion;
}

/// Closed form of undamped stick-slip in (y, y'): the belt carries the mass at -V to -mu_s N. Then it moves
/// on a circle about (-mu_k N, 0) until it reaches the belt's speed on the opposite side.
struct StickSlip {
  double surface, centre, excess;

  explicit StickSlip(const Belt& belt)
      : surface(belt.surface),
        centre(-model::holding_and_sliding(belt.friction)[1] * belt.normal),
        excess(model::holding_and_sliding(belt.friction)[0] * belt.normal + centre) {}

  double carried() const { return 2 * excess / surface; }
  double period() const { return carried() + 2 * pi - 2 * std::atan(excess / surface); }
  double amplitude() const { return std::hypot(excess, surface); }
  /// State at time t after the beginning of sticking.
  std::pair<double, double> at(double t) const {
    t = std::fmod(t, period());
    if (t < carried()) return {centre + excess - surface * t, -surface};
    const double c = std::cos(t - carried()), s = std::sin(t - carried());
    return {centre - excess * c - surface * s, excess * s - surface * c};
  }
};

TEST(StaticFriction, StickSlipOnABeltIsALineAndTheArcOfACircle) {
  for (const double surface : {0.05, 0.3, 2.0}) {
    for (const double mu_k : {0.01, 0.25, 0.59}) {
      const Belt belt{.friction = StaticFriction{0.6, mu_k}, .surface = surface, .revolution = 0.7};
      const StickSlip closed(belt);
      const scene::Scene scene = belt.scene(closed.at(0).first, -surface);
      const Motion pieces = run_of(scene, {}, 60);
      const Motion steps = run_of(scene, adaptive(run::Stepper::rkf78, 1e-12), 60);
      double error = 0, of_steps = 0;
      for (std::size_t k = 0; k < pieces.states.size(); ++k) {
        const auto [y, rate] = closed.at(0.7 * static_cast<double>(k + 1));
        error =
            std::max({error, std::abs(pieces.states[k].first - y), std::abs(pieces.states[k].second - rate)});
        of_steps = std::max(
            {of_steps, std::abs(steps.states[k].first - y), std::abs(steps.states[k].second - rate)});
      }
      // Errors of period or amplitude would accumulate over the turns.
      EXPECT_LT(error, 1e-12) << surface << ' ' << mu_k;
      EXPECT_LT(of_steps, 1e-8) << surface << ' ' << mu_k;
      EXPECT_EQ(pieces.last.effort.adaptive_turns, 0);
    }
  }
}

TEST(StaticFriction, PeriodAndAmplitudeAreThoseOfTheClosedForm) {
  const Belt belt{.surface = 0.3, .revolution = StickSlip(Belt{}).period()};
  const StickSlip closed(belt);
  exact::modes::ModeCache modes;
  const run::Run run = start(belt.scene(closed.at(0).first, -0.3), {}, modes);
  run::TurnRequest asked;
  asked.samples_per_revolution = 4096;
  run::TurnReport turn;
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
    double low = 0, high = -10;
    for (std::size_t i = 1; i < turn.samples.size(); i += 4) {
      low = std::min(low, turn.samples[i]);
      high = std::max(high, turn.samples[i]);
    }
    EXPECT_NEAR(turn.section[1], closed.at(0).first, 1e-13);
    EXPECT_NEAR((high - low) / 2, closed.amplitude(), 1e-6);
    // one switch may be exactly at the section
    EXPECT_NEAR(static_cast<double>(turn.effort.switches), 2 * (k + 1), 1);
  }
}

TEST(StaticFriction, WithDampingItSlidesForEverAboveTheSpeedOfTheClosedForm) {
  // The mass is released at z = cV - excess, relative to the centre, with z' = -V. It slides on if the damped
  // motion does not reach -V again; the closest approach is at z'' = 0.
  const double c = 0.2, excess = 0.7, decay = c / 2, rate = std::sqrt(1 - decay * decay);
  const auto fastest_return = [&](double v) {
    const double from = c * v - excess, b = (-v + decay * from) / rate;
    double least = 0;
    for (int k = 1; k <= 400'000; ++k) {
      const double t = 3 + 5.0 * k / 400'000, e = std::exp(-decay * t);
      least = std::min(least, e * ((rate * b - decay * from) * std::cos(rate * t) -
                                   (rate * from + decay * b) * std::sin(rate * t)));
    }
    return least;
  };
  double low = 0.1, high = 3;
  for (int k = 0; k < 40; ++k) {
    const double v = (low + high) / 2;
    (fastest_return(v) <= -v ? low : high) = v;
  }
  EXPECT_GT(low, 0.3);
  for (const double share : {0.99, 0.999, 1.001, 1.01}) {
    const double v = share * low;
    const Belt belt{.damping = c, .surface = v, .revolution = 2};
    const Motion motion = run_of(belt.scene(-0.5, -v), {}, 300),
                 before = run_of(belt.scene(-0.5, -v), {}, 200);
    const bool goes_on = motion.last.effort.switches > before.last.effort.switches;
    EXPECT_EQ(goes_on, share < 1) << share;
    if (share > 1) {
      EXPECT_NEAR(motion.states.back().first, -0.5, 1e-9);
    }
  }
}

TEST(StaticFriction, SteadySlidingOnAFallingCurveIsStableAboveTheSpeedWhereDampingOutweighsTheFall) {
  // Critical damping c = N (mu_s - mu_k) / v_s exp(-V / v_s); for exponent 2 an additional factor 2 V / v_s.
  const double c = 0.1, normal = 2, drop = 0.3, fall = 0.5;
  for (const int exponent : {1, 2}) {
    const auto slope = [&](double v) {
      const double x = v / fall;
      return normal * drop / fall * (exponent == 1 ? std::exp(-x) : 2 * x * std::exp(-x * x));
    };
    double low = fall, high = 10 * fall;
    for (int k = 0; k < 60; ++k) (slope((low + high) / 2) > c ? low : high) = (low + high) / 2;
    for (const double share : {0.97, 1.03}) {
      const double v = share * low;
      const Belt belt{.friction = FallingFriction{0.5, 0.2, fall, exponent},
                      .damping = c,
                      .surface = v,
                      .revolution = 2 * pi};
      const double mu = 0.2 + drop * std::exp(exponent == 1 ? -v / fall : -v * v / fall / fall);
      const Motion motion = run_of(belt.scene(-mu * normal + 1e-6, 0), {}, 40);
      const auto away = [&](std::size_t k) {
        return std::hypot(motion.states[k].first + mu * normal, motion.states[k].second);
      };
      // The amplitude changes by exp(-(c - slope) t / 2).
      const double turns = 30, expected = std::exp(-(c - slope(v)) * turns * pi);
      EXPECT_NEAR(std::log(away(39) / away(9)), std::log(expected), 0.02) << exponent << ' ' << share;
      EXPECT_EQ(motion.last.effort.switches, 0);
    }
  }
}

TEST(StaticFriction, BetweenRabinowiczTwoCoefficientsARestingBlockStaysAndAMovingOneGoesOn) {
  // A block on a ramp whose slope lies between both friction coefficients: N acts normal to it, slope N along
  // it.
  for (const double slope : {0.3, 0.59}) {
    const Belt ramp{.surface = 0, .revolution = 0.5, .spring = 0, .along = 2 * slope};
    EXPECT_EQ(run_of(ramp.scene(0, 0), {}, 20).states.back(), (std::pair{0.0, 0.0}));
    const Motion moving = run_of(ramp.scene(0, 1e-3), {}, 6);
    const double a = 2 * (slope - 0.25), t = 3;
    EXPECT_NEAR(moving.states.back().first, 1e-3 * t + a * t * t / 2, 1e-12);
    EXPECT_NEAR(moving.states.back().second, 1e-3 + a * t, 1e-12);
    // Moving up the ramp, it stops and stays.
    const Motion up = run_of(ramp.scene(0, -1), {}, 20);
    EXPECT_NEAR(up.states.back().first, -1 / (4 * (slope + 0.25)), 1e-12);
    EXPECT_EQ(up.last.effort.switches, 1);
  }
  const Belt steep{.surface = 0, .revolution = 0.5, .spring = 0, .along = 2 * 0.61};
  EXPECT_NEAR(run_of(steep.scene(0, 0), {}, 6).states.back().first, 2 * (0.61 - 0.25) * 4.5, 1e-12);
}

/// Each swing goes about the place where sliding friction balances spring and slope. The first rest within
/// the static bound is the last.
TEST(StaticFriction, AnOscillatorOnARampSwingsAboutTwoPlacesUntilStaticFrictionHoldsIt) {
  for (const double slope : {0.0, 0.3, -0.45}) {
    for (const double from : {4.7, -3.3}) {
      const Belt ramp{.surface = 0, .revolution = 0.5, .along = 2 * slope};
      double rest = from;
      int swings = 0;
      for (; std::abs(rest - ramp.along) > 0.6 * ramp.normal; ++swings)
        rest = 2 * (ramp.along + std::copysign(0.25 * ramp.normal, rest - ramp.along)) - rest;
      ASSERT_GT(swings, 1);
      for (const run::SolverOptions& options : {run::SolverOptions{}, adaptive(run::Stepper::rkf78, 1e-12)})
        EXPECT_NEAR(run_of(ramp.scene(from, 0), options, 60).states.back().first, rest, 1e-10)
            << slope << ' ' << from;
    }
  }
}

TEST(StaticFriction, EqualCoefficientsAreDryFriction) {
  for (const model::Friction& equal :
       {model::Friction(StaticFriction{0.25, 0.25}), model::Friction(FallingFriction{0.25, 0.25, 0.1, 2})}) {
    const Belt belt{.friction = equal, .damping = 0.1, .surface = 0.8, .revolution = 3};
    Belt dry = belt;
    dry.friction = model::ConstantFriction{0.25};
    EXPECT_EQ(run_of(belt.scene(1.5, 2), {}, 10).states, run_of(dry.scene(1.5, 2), {}, 10).states);
  }
}

TEST(StaticFriction, TwoWallsOfOneRigidCasingHoldWhatOneDoes) {
  // The distribution of friction between the two walls is not unique, but their joint limit is.
  for (const model::Friction& friction :
       {model::Friction(StaticFriction{0.6, 0.25}), model::Friction(FallingFriction{0.6, 0.25, 0.2, 1})}) {
    const Belt belt{.friction = friction, .damping = 0.05, .revolution = 0.7};
    for (const double share : {0.5, 0.2}) {
      scene::Scene two = belt.scene(0, -belt.surface);
      two.contacts.push_back(two.contacts[0]);
      two.contacts[0].stiffness_n_per_m *= share;
      two.contacts[1].stiffness_n_per_m *= 1 - share;
      const Motion one = run_of(belt.scene(0, -belt.surface), {}, 40);
      for (const run::SolverOptions& options : {run::SolverOptions{}, adaptive(run::Stepper::rkf78, 1e-12)}) {
        const Motion both = run_of(two, options, 40);
        for (std::size_t k = 0; k < one.states.size(); ++k)
          EXPECT_NEAR(both.states[k].first, one.states[k].first, 1e-8) << share << ' ' << k;
      }
    }
  }
}

/// Number of friction laws for the random machines.
constexpr int laws = 3;

struct Machine {
  scene::Scene scene;
  test::StickSlipReference reference;
};

/// One mass on walls or in a ring with slow surfaces; the excitation makes slips stop and reverse.
Machine random_machine(std::mt19937& random, int law) {
  const auto even = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Machine m;
  const double damping = even(0.02, 0.2), speed = even(0.8, 3), force = even(0.5, 3);
  m.scene = test::one_mass_scene(1, 1, damping, 2 * pi / speed, 1);
  m.scene.harmonic_n << force, std::complex<double>(0, -force);
  m.scene.constant_n << even(0, 0.5), even(-0.5, 0.5);
  const int kind = std::uniform_int_distribution(0, 3)(random);  // 0: a ring; otherwise the number of walls
  for (int k = 0; k < std::max(1, kind); ++k) {
    scene::Contact stop;
    test::StickSlipReference::Wall wall;
    wall.ring = kind == 0;
    if (wall.ring) {
      const Eigen::Vector2d offset(even(-0.2, 0.2), even(-0.2, 0.2));
      stop.wall = contact::AnnularWall{{offset.x(), offset.y()}};
      wall.x = offset.x(), wall.y = offset.y();
    } else {
      const double angle = even(0, 2 * pi);
      const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
      stop.wall = contact::FlatWall{normal};
      wall.x = normal.x(), wall.y = normal.y();
    }
    stop.clearance_m = even(0.8, 1.2);
    stop.stiffness_n_per_m = even(20, 200);
    stop.damping_ns_per_m = even(0, 3);
    if (even(0, 1) < 0.3) stop.damping_ns_per_m = 0;
    stop.surface_speed_m_per_s = even(-0.2, 1);
    const double holds = even(0.2, 0.9), slides = holds * even(0, 0.95), fall = even(0.1, 0.6);
    stop.friction = law == 0 ? model::Friction(StaticFriction{holds, slides})
                             : model::Friction(FallingFriction{holds, slides, fall, law});
    wall.clearance = stop.clearance_m;
    wall.stiffness = stop.stiffness_n_per_m;
    wall.damping = stop.damping_ns_per_m;
    wall.surface_speed = stop.surface_speed_m_per_s;
    wall.holds = holds, wall.slides = slides, wall.fall_speed = law == 0 ? 0 : fall, wall.power = law;
    m.scene.contacts.push_back(stop);
    m.reference.walls.push_back(wall);
  }
  m.scene.displacement_m << even(-0.5, 0.5), even(-0.5, 0.5);
  m.scene.velocity_m_per_s << even(-2, 2), even(-2, 2);
  test::StickSlipReference& r = m.reference;
  r.damper = damping, r.turns_at = m.scene.speed_rad_per_s, r.force = force;
  r.constant_x = m.scene.constant_n(0), r.constant_y = m.scene.constant_n(1);
  r.state = {m.scene.displacement_m(0), m.scene.displacement_m(1), m.scene.velocity_m_per_s(0),
             m.scene.velocity_m_per_s(1)};
  r.step = m.scene.period_s() / 160;
  return m;
}

bool all_corners() { return std::getenv("RUBSWEEP_CORNERS") != nullptr; }

/// The same mass pressed into a corner of two walls, which hold it until both release it.
Machine random_corner(std::mt19937& random, int law) {
  Machine m = random_machine(random, law);
  while (m.scene.contacts.size() != 2) m = random_machine(random, law);
  const auto even = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  m.scene.constant_n << even(-0.5, 0.5), -even(4, 6);
  m.reference.constant_x = m.scene.constant_n(0), m.reference.constant_y = m.scene.constant_n(1);
  for (std::size_t k = 0; k < 2; ++k) {
    const double angle = (k == 0 ? -1 : 1) * even(0.5, 0.9) - pi / 2;
    const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
    m.scene.contacts[k].wall = contact::FlatWall{normal};
    m.reference.walls[k].x = normal.x(), m.reference.walls[k].y = normal.y();
    m.scene.contacts[k].surface_speed_m_per_s = 0;
    m.reference.walls[k].surface_speed = 0;
    m.reference.step = m.scene.period_s() / (all_corners() ? 1000 : 250);
  }
  return m;
}

/// Difference of a section from the reference, in the units of the reference.
std::vector<double> difference(const std::vector<double>& section, const test::StickSlipReference& reference,
                               double speed) {
  std::vector<double> all;
  for (std::size_t k = 0; k < 4; ++k)
    all.push_back(static_cast<double>(section[k] * (k < 2 ? 1 : speed) - reference.state[k]));
  return all;
}

double largest(const std::vector<double>& all) {
  double most = 0;
  for (const double one : all) most = std::max(most, std::abs(one));
  return most;
}

struct Tally {
  int machines = 0, stops = 0, releases = 0, together = 0, sensitive = 0;
  double worst = 0, worst_of_steps = 0;  ///< errors / growth
};

/// Runs six turns; the error is divided by the growth of a small change in the initial state.
Tally compare(int law, int machines, unsigned seed, Machine (*machine)(std::mt19937&, int) = random_machine) {
  constexpr double small = 1e-9, most_growth = 1e5;
  std::mt19937 random(seed);
  Tally tally;
  for (int cell = 0; cell < machines; ++cell) {
    Machine m = machine(random, law);
    test::StickSlipReference near = m.reference;
    for (auto& number : near.state) number += small;
    exact::modes::ModeCache modes;
    const run::Run run = start(m.scene, {}, modes),
                   other = start(m.scene, adaptive(run::Stepper::rkf78, 1e-13), modes);
    run::TurnReport a, b;
    m.reference.begin();
    near.begin();
    const double speed = m.scene.speed_rad_per_s;
    double growth = 1;
    for (int turn = 0; turn < 6; ++turn) {
      EXPECT_EQ(run.advance({}, a), run::Outcome::ok) << cell;
      EXPECT_EQ(other.advance({}, b), run::Outcome::ok) << cell;
      m.reference.go(m.scene.period_s());
      near.go(m.scene.period_s());
      for (std::size_t k = 0; k < 4; ++k)
        growth =
            std::max(growth, static_cast<double>(std::abs(near.state[k] - m.reference.state[k])) / small);
    }
    ++tally.machines;
    tally.stops += m.reference.stops, tally.releases += m.reference.releases;
    tally.together += m.reference.together;
    // Growth means nothing where the small change leads to different stops or releases.
    if (growth > most_growth) {
      ++tally.sensitive;
      continue;
    }
    const double error = largest(difference(a.section, m.reference, speed)) / growth;
    EXPECT_LT(error, 1e-10) << "law " << law << " cell " << cell << " growth " << growth;
    tally.worst = std::max(tally.worst, error);
    const double of_steps = largest(difference(b.section, m.reference, speed)) / growth;
    EXPECT_LT(of_steps, 1e-7) << "law " << law << " cell " << cell << " growth " << growth;
    tally.worst_of_steps = std::max(tally.worst_of_steps, of_steps);
  }
  return tally;
}

class StaticFrictionReference : public testing::TestWithParam<int> {};

TEST_P(StaticFrictionReference, RandomMachinesMeetLongDoubles) {
  const Tally tally = compare(GetParam(), 8, 11);
  EXPECT_GT(tally.stops, 20);
  EXPECT_GT(tally.releases, 10);
  EXPECT_LE(tally.sensitive, 1);
}

/// RUBSWEEP_CORNERS=1 tests all laws with a finer reference, which falling curves need: two minutes.
TEST(StaticFriction, CornersWhereTwoLetGoAtOnceMeetLongDoubles) {
  for (int law = 0; law < (all_corners() ? laws : 1); ++law) {
    const Tally tally = compare(law, 8, 3, random_corner);
    EXPECT_GT(tally.releases, 10) << law;
    EXPECT_LE(tally.sensitive, 1) << law;
    if (law == 0) {
      EXPECT_GT(tally.together, 4);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, StaticFrictionReference, testing::Range(0, laws));

class StaticFrictionTangents : public testing::TestWithParam<int> {};

TEST_P(StaticFrictionTangents, AreDerivatives) {
  std::mt19937 random(5);
  int compared = 0, good = 0, lost = 0;
  for (int cell = 0; cell < 40; ++cell) {
    const Machine m = random_machine(random, GetParam());
    exact::modes::ModeCache modes;
    const run::Run run = start(m.scene, {}, modes);
    const double speed = m.scene.speed_rad_per_s;
    std::vector<double> before{m.scene.displacement_m(0), m.scene.displacement_m(1),
                               m.scene.velocity_m_per_s(0) / speed, m.scene.velocity_m_per_s(1) / speed};
    for (int k = 0; k < 5; ++k) {
      run::TurnRequest asked;
      run::TurnReport turn;
      const auto turn_from = [&](const std::vector<double>& state) {
        run.restart(state);
        EXPECT_EQ(run.advance(asked, turn), run::Outcome::ok);
        return turn.section;
      };
      asked.tangent_vectors.setIdentity(4, 4);
      const std::vector<double> after = turn_from(before);
      if (const Eigen::MatrixXd* moved = turn.tangent_vectors.get()) {
        const Eigen::MatrixXd by_solver = *moved;
        lost += std::abs(by_solver.determinant()) < 1e-9;
        asked.tangent_vectors.resize(4, 0);
        double worst = 0;
        for (std::size_t j = 0; j < 4; ++j) {
          constexpr double d = 1e-7;
          std::vector<double> up = before, down = before;
          up[j] += d, down[j] -= d;
          const std::vector<double> a = turn_from(up), b = turn_from(down);
          for (std::size_t r = 0; r < 4; ++r) {
            const double exact = by_solver(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(j));
            worst = std::max(worst, std::abs((a[r] - b[r]) / (2 * d) - exact) / (1 + by_solver.norm()));
          }
        }
        ++compared;
        good += worst < 1e-4;
      }
      before = after;
    }
  }
  EXPECT_GT(lost, 30);
  // Differences across a grazing contact are not derivatives.
  EXPECT_GE(good, compared - compared / 20) << compared;
}

INSTANTIATE_TEST_SUITE_P(Laws, StaticFrictionTangents, testing::Range(0, laws));

}  // namespace
}  // namespace rubsweep::integrate
