#include "rubsweep/core/integrate/taylor/taylor_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "core/integrate/rubbing_kit.hpp"
#include "core/integrate/taylor/set_c_scene.hpp"
#include "rubsweep/core/integrate/adaptive/adaptive_run.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/hybrid_run.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/rotating/rotating_flow.hpp"
#include "support/annular_scene.hpp"
#include "support/rolling_scene.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Mode;
using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
constexpr Complex i{0, 1};

run::SolverOptions tight(double tolerance = 1e-13) {
  run::SolverOptions options;
  options.method = run::Method::adaptive;
  options.stepper = run::Stepper::rkf78;
  options.relative_tolerance = tolerance;
  return options;
}

struct Agreement {
  double section = 0, samples = 0, fraction = 0, displacement = 0, casing = 0, force = 0, phase = 0;
  int hits = 0;
  double contact_turns = 0;
};

/// Starts every turn from the sections of the Taylor run, so that chaos separates the two solvers for one
/// turn only. `other` starts at revolution 0 each time, because the scene has no kick and no impulses.
template <int N>
Agreement compare(scene::Scene scene, const run::Run& other, int turns) {
  scene.pulses.clear();
  TaylorRun<N> run(scene, {});
  const run::TurnRequest asked{.samples_per_revolution = 16, .peaks = true, .switches = true};
  run::TurnReport a, b;
  Agreement all;
  for (int k = 0; k < turns; ++k) {
    const std::vector<double> before = run.section();
    EXPECT_EQ(run.advance(asked, a), run::Outcome::ok);
    other.restart(before);
    EXPECT_EQ(other.advance(asked, b), run::Outcome::ok);
    EXPECT_EQ(a.hits, b.hits) << "turn " << k;
    EXPECT_EQ(a.touching_at_end, b.touching_at_end) << "turn " << k;
    EXPECT_EQ(a.touched, b.touched) << "turn " << k;
    EXPECT_EQ(a.slip_reversed, b.slip_reversed) << "turn " << k;
    EXPECT_EQ(a.switches.size(), b.switches.size()) << "turn " << k;
    if (a.switches.size() == b.switches.size()) {
      for (std::size_t j = 0; j < a.switches.size(); ++j) {
        EXPECT_EQ(a.switches[j].to, b.switches[j].to) << "turn " << k;
        all.phase = std::max(all.phase, std::abs(a.switches[j].phase_rad - b.switches[j].phase_rad));
      }
    }
    all.section = std::max(all.section, largest_difference(a.section, b.section));
    all.samples = std::max(all.samples, largest_difference(a.samples, b.samples));
    all.fraction = std::max(all.fraction, std::abs(a.contact_fraction - b.contact_fraction));
    all.displacement = std::max(
        all.displacement, std::abs(a.peak_displacement_m - b.peak_displacement_m) / scene.length_scale_m);
    all.casing = std::max(all.casing, std::abs(a.peak_casing_displacement_m - b.peak_casing_displacement_m) /
                                          scene.length_scale_m);
    all.force = std::max(all.force, std::abs(a.peak_contact_force_n - b.peak_contact_force_n) /
                                        std::max(1.0, b.peak_contact_force_n));
    all.hits += a.hits;
    all.contact_turns += a.contact_fraction;
  }
  return all;
}

/// Peaks between states are found by cubics; the two solvers have different distances between states.
void expect_small(const Agreement& all, double tolerance, const char* name, double peaks = 5e-6) {
  EXPECT_LT(all.section, tolerance) << name;
  EXPECT_LT(all.samples, tolerance) << name;
  EXPECT_LT(all.fraction, tolerance) << name;
  EXPECT_LT(all.phase, 10 * tolerance) << name;
  EXPECT_LT(all.displacement, peaks) << name;
  // Steps of rkf78 are long compared with a casing's vibration.
  EXPECT_LT(all.casing, 10 * peaks) << name;
  EXPECT_LT(all.force, 1e-5) << name;
}

/// Between flat stops the exact solver is more accurate than any stepper.
TEST(TaylorRun, AgreesWithTheExactSolverBetweenFlatStops) {
  exact::modes::ModeCache modes;
  for (const auto& [speed_hz, ratio] : {std::pair{75.0, 0.4}, std::pair{110.0, 0.7}, std::pair{60.0, 0.9}}) {
    test::OneSideRotor rotor;
    rotor.speed_hz = speed_hz;
    rotor.whirl_ratio = ratio;
    scene::Scene scene = test::cell_of(rotor).scene;
    TaylorRun<4> kicked(scene, {});
    const auto exact_kicked = start_hybrid(scene, {}, modes);
    run::TurnReport a, b;
    for (int k = 0; k < 4; ++k) {
      ASSERT_EQ(kicked.advance({}, a), run::Outcome::ok);
      ASSERT_EQ(exact_kicked.advance({}, b), run::Outcome::ok);
      EXPECT_LT(largest_difference(a.section, b.section), 1e-13);
    }
    scene = [&] {
      scene::Scene later = scene;
      later.pulses.clear();
      for (Eigen::Index j = 0; j < 4; ++j) {
        later.displacement_m(j) = a.section[std::size_t(j)] * scene.length_scale_m;
        later.velocity_m_per_s(j) =
            a.section[std::size_t(j) + 4] * scene.length_scale_m * scene.speed_rad_per_s;
      }
      return later;
    }();
    const Agreement all = compare<4>(scene, start_hybrid(scene, {}, modes), 30);
    EXPECT_GT(all.hits, 3);
    expect_small(all, 1e-13, "flat", 1e-3);
  }
}

TEST(TaylorRun, AgreesWithTheExactSolverOnAKit) {
  exact::modes::ModeCache modes;
  scene::Scene scene = kit_scene(70, 0.7);
  const Agreement all = compare<Eigen::Dynamic>(
      scene,
      [&] {
        scene.pulses.clear();
        return start_hybrid(scene, {}, modes);
      }(),
      5);
  expect_small(all, 1e-11, "kit", 1e-3);
}

TEST(TaylorRun, AgreesWithRkf78InAnnularStops) {
  exact::modes::ModeCache modes;
  struct Case {
    const char* name;
    scene::Scene scene;
    std::array<double, 4> start;
  };
  const std::array cases{
      Case{"circle", set_c_scene(80, 0.6), {1.6, 0, 0, 1.5}},
      Case{"oval", set_c_scene(165, 0.6), {0.9, 0.7, -0.4, 0.9}},
      Case{"offset", set_c_scene(120, 0.7, {0, 2.5e-4}), {1.1, 0, 0.2, 1.0}},
      Case{"far offset", set_c_scene(60, 0.3, {-7e-4, 2e-4}), {0.2, 0.9, 0.4, -0.3}},
  };
  for (const Case& c : cases) {
    scene::Scene scene = c.scene;
    scene.pulses.clear();
    for (Eigen::Index j = 0; j < 2; ++j) {
      scene.displacement_m(j) = c.start[std::size_t(j)] * scene.length_scale_m;
      scene.velocity_m_per_s(j) = c.start[std::size_t(j) + 2] * scene.length_scale_m * scene.speed_rad_per_s;
    }
    const Agreement all = compare<4>(scene, start(scene, tight(), modes), 20);
    EXPECT_GT(all.contact_turns, 1) << c.name;
    expect_small(all, 2e-11, c.name);
  }
}

TEST(TaylorRun, AgreesWithRkf78WhereFrictionVariesAndReverses) {
  exact::modes::ModeCache modes;
  for (const double steepness : {30.0, 300.0}) {
    // A screw touches a thin shaft: the slip reverses in every turn.
    test::OneSideRotor rotor;
    rotor.contact_radius_m = 5e-4;
    rotor.friction_steepness_s_per_m = steepness;
    rotor.whirl_ratio = 0.8;
    scene::Scene flat = test::cell_of(rotor).scene;
    flat.pulses.clear();
    flat.displacement_m(1) = 1.4e-3;
    const Agreement on_flat = compare<4>(flat, start(flat, tight(), modes), 12);
    EXPECT_GT(on_flat.hits, 5);
    expect_small(on_flat, 1e-11, "flat");
    scene::Scene annular = set_c_scene(90, 0.6);
    annular.pulses.clear();
    annular.contacts[0].surface_speed_m_per_s = 0.1;
    annular.contacts[0].friction =
        model::StribeckFriction{{0.05, steepness, steepness / 10, 0.1, steepness, 0.001}};
    annular.displacement_m.head(2) << 1.3e-3, 0.2e-3;
    annular.velocity_m_per_s.head(2) << 0.1, -0.5;
    const Agreement in_ring = compare<4>(annular, start(annular, tight(), modes), 12);
    EXPECT_GT(in_ring.hits, 1);
    expect_small(in_ring, 1e-11, "annular");
  }
}

/// An annular stop and two flat ones with overlapping ranges.
TEST(TaylorRun, TakesStopsOfBothKindsTogether) {
  exact::modes::ModeCache modes;
  scene::Scene scene = test::annular_scene(1, 0.02, 1.7, 0.5, 0, 60, 0.1);
  for (const double angle : {0.3, 2.5}) {
    scene::Contact wall = test::wall_across_x(1, 0.8, 40, 0.6);
    wall.wall = contact::FlatWall{{std::cos(angle), std::sin(angle)}};
    wall.friction = model::StribeckFriction{{0, 0, 0, 0.2, 3, 0}};
    wall.surface_speed_m_per_s = 0.5;
    scene.contacts.push_back(wall);
  }
  scene.contacts[0].damping_ns_per_m = 0.8;
  test::start_at(scene, 0.5, Complex(0.2, 1.2));
  const Agreement all = compare<2>(scene, start(scene, tight(), modes), 20);
  EXPECT_GT(all.hits, 20);
  expect_small(all, 2e-11, "both");
}

TEST(TaylorRun, StaysOnTheClosedFormsOfFullRubAndDryWhip) {
  const test::FullRub rub;
  TaylorRun<2> full(rub.scene(), {});
  run::TurnReport turn;
  for (int k = 0; k < 20; ++k) {
    ASSERT_EQ(full.advance({.samples_per_revolution = 16, .peaks = true}, turn), run::Outcome::ok);
    EXPECT_DOUBLE_EQ(turn.contact_fraction, 1);
    for (std::size_t j = 0; j < 16; ++j)
      EXPECT_NEAR(std::hypot(turn.samples[4 * j], turn.samples[4 * j + 1]), rub.radius, 1e-13);
    EXPECT_NEAR(turn.peak_contact_force_n, rub.k_c * (rub.radius - 1), 1e-11);
  }
  // Dry whip, an unstable motion here. Without unbalance: w = zeta/mu + sqrt((zeta/mu)^2 + 1), r = 1 / (1 - 2
  // zeta w / (mu b)).
  const double zeta = 0.05, mu = 0.2, b = 20;
  const double w = zeta / mu + std::sqrt(zeta * zeta / (mu * mu) + 1);
  const double radius = 1 / (1 - 2 * zeta * w / (mu * b));
  scene::Scene whip = test::annular_scene(1, zeta, 1, 0, 0, b, mu);
  test::start_at(whip, radius, -i * w * radius);
  TaylorRun<2> run(whip, {});
  for (int k = 1; k <= 5; ++k) {
    ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
    const Complex z(turn.section[0], turn.section[1]);
    EXPECT_LT(std::abs(z - radius * std::exp(-i * (2 * pi * w * k))), 1e-10);
  }
}

TEST(TaylorRun, RollsBackwardOnItsClosedForm) {
  for (const double steepness : {1.0, 10.0, 100.0}) {
    const test::RollingScene rolling = test::rolling_scene(steepness);
    TaylorRun<2> run(rolling.scene, {});
    run::TurnReport turn;
    for (int k = 1; k <= 3; ++k) {
      ASSERT_EQ(run.advance({}, turn), run::Outcome::ok) << steepness;
      const Complex z(turn.section[0], turn.section[1]);
      EXPECT_LT(std::abs(z - rolling.displacement(k)), 1e-11) << steepness;
    }
    EXPECT_DOUBLE_EQ(turn.contact_fraction, 1);
  }
}

/// Elastic stops without damping, friction and unbalance conserve the energy of rotor, casing and contact
/// springs.
TEST(TaylorRun, KeepsTheEnergyOfAConservativeScene) {
  scene::Scene scene = set_c_scene(80, 0.6, {1e-4, -2e-4});
  scene.pulses.clear();
  scene.harmonic_n.setZero();
  scene.structure.damping.setZero();
  scene.contacts[0].damping_ns_per_m = 0;
  scene.contacts[0].friction = model::NoFriction{};
  scene::Contact wall = test::wall_across_x(1, 6e-4, 1e6, 0);
  wall.rotor_point = scene.contacts[0].rotor_point;
  scene.contacts.push_back(wall);
  scene.displacement_m << 0.5e-3, 0.3e-3, 0, 0;
  scene.velocity_m_per_s << 0.6, -0.8, 0, 0;
  const auto energy = [&](const std::vector<double>& section) {
    const Eigen::Map<const Eigen::VectorXd> s(section.data(), 8);
    const Eigen::VectorXd q = s.head(4) * scene.length_scale_m,
                          v = s.tail(4) * (scene.length_scale_m * scene.speed_rad_per_s);
    double sum = v.dot(scene.structure.mass * v) + q.dot(scene.structure.stiffness * q);
    const auto& c = scene.contacts[0];
    const auto& points = scene.structure.points;
    const Eigen::Vector2d rotor = points[std::size_t(c.rotor_point)].map * q,
                          d = rotor - points[std::size_t(*c.casing_point)].map * q + contact::offset(c.wall);
    const double p = std::max(0.0, d.norm() - c.clearance_m), flat = std::max(0.0, rotor.x() - 6e-4);
    return (sum + c.stiffness_n_per_m * p * p + 1e6 * flat * flat) / 2;
  };
  TaylorRun<4> run(scene, {});
  const double start = energy(run.section());
  run::TurnReport turn;
  int hits = 0;
  for (int k = 0; k < 100; ++k) {
    ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
    hits += turn.hits;
    EXPECT_NEAR(energy(turn.section) / start, 1, 1e-12) << k;
  }
  EXPECT_GT(hits, 100);
}

TEST(TaylorRun, NeedsFewerStepsAtHigherOrderForTheSameMotion) {
  scene::Scene scene = set_c_scene(165, 0.6);
  TaylorRun<4> best(scene, {});
  std::vector<double> reference;
  run::TurnReport turn;
  for (int k = 0; k < 6; ++k) ASSERT_EQ(best.advance({}, turn), run::Outcome::ok);
  reference = turn.section;
  long last = 1'000'000;
  for (const int order : {10, 14, 18, 22}) {
    TaylorRun<4> run(scene, {}, {.order = order});
    for (int k = 0; k < 6; ++k) ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
    EXPECT_LT(largest_difference(turn.section, reference), 1e-12) << order;
    EXPECT_LT(run.effort().steps, last);
    last = run.effort().steps;
  }
}

/// A freely vibrating rotor moves on an ellipse whose long half-axis exceeds the wall's distance by `excess`,
/// which may be negative.
TEST(TaylorRun, SeesAGrazeAsShallowAsRounding) {
  for (const bool annular : {false, true}) {
    for (const double excess : {1e-6, 1e-9, 1e-12, 1e-13}) {
      for (const double sign : {1.0, -1.0}) {
        scene::Scene scene = test::one_mass_scene(1, 1, 0, 2 * pi, 1);
        scene::Contact stop = test::wall_across_x(1, 1, 50, 0);
        if (annular) stop.wall = contact::AnnularWall{};
        scene.contacts.push_back(stop);
        scene.displacement_m << 0, 0.4;
        scene.velocity_m_per_s << 1 + sign * excess, 0;
        TaylorRun<2> run(scene, {});
        run::TurnReport turn;
        ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
        EXPECT_EQ(turn.hits, sign < 0 ? 0 : annular ? 2 : 1) << annular << " " << sign * excess;
      }
    }
  }
}

/// Largest value of all armed guards at many states of a turn, in the modes that the run reports: none may be
/// positive.
double worst_guard(const scene::Scene& scene, const std::vector<Mode>& modes_at_start,
                   const run::TurnReport& turn) {
  const auto system = run::scale<Eigen::Dynamic>(scene);
  law::Dynamics<Eigen::Dynamic, false> dynamics(system, 0);
  dynamics.modes() = modes_at_start;
  const std::size_t states = 2 * std::size_t(system.coordinates());
  double worst = -1;
  std::size_t next = 0;
  std::vector<double> state(states), rate(states);
  for (int k = 0; k < turn.sample_count; ++k) {
    const double phase = 2 * pi * k / turn.sample_count;
    for (; next < turn.switches.size() && turn.switches[next].phase_rad <= phase; ++next)
      dynamics.modes()[std::size_t(turn.switches[next].contact)] = turn.switches[next].to;
    std::copy_n(turn.samples.begin() + std::ptrdiff_t(std::size_t(k) * states), states, state.begin());
    dynamics(state, rate, phase);
    for (std::size_t c = 0; c < system.contacts.size(); ++c) {
      const auto& law = system.contacts[c];
      const auto guards = contact::guards_of(dynamics.modes()[c], law.stiffness, law.damping,
                                             dynamics.kinematics(c, state, rate));
      for (int e = 0; e < guards.count; ++e) {
        const auto& guard = guards.list[std::size_t(e)];
        const double unit = dynamics.modes()[c] == Mode::open || guard.next == Mode::open ? 1 : law.stiffness;
        worst = std::max(worst, guard.value / unit);
      }
    }
  }
  return worst;
}

/// About ten steps per turn with many points in each: no guard may be passed over.
TEST(TaylorRun, PassesOverNoGuardThatFiveThousandPointsATurnSee) {
  int hits = 0;
  for (const auto& [speed_hz, ratio] :
       {std::pair{80.0, 0.6}, std::pair{120.0, 0.9}, std::pair{165.0, 0.6}, std::pair{230.0, 0.3}}) {
    scene::Scene scene = set_c_scene(speed_hz, ratio, {0, 2.5e-4});
    scene.pulses.clear();
    scene::Contact wall = test::wall_across_x(-1, 8e-4, 2e6, 300);
    wall.rotor_point = scene.contacts[0].rotor_point;
    wall.casing_point = scene.contacts[0].casing_point;
    wall.friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}};
    wall.surface_speed_m_per_s = 0.4;
    scene.contacts.push_back(wall);
    scene.displacement_m.head(2) << 0.5e-3, 0.3e-3;
    scene.velocity_m_per_s.head(2) << 0.4, -0.6;
    TaylorRun<4> run(scene, {});
    run::TurnReport turn;
    const run::TurnRequest asked{.samples_per_revolution = 5000, .switches = true};
    std::vector<Mode> modes(2, Mode::open);
    for (int k = 0; k < 20; ++k) {
      ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
      EXPECT_LT(worst_guard(scene, modes, turn), 1e-12) << speed_hz << " Hz, turn " << k;
      for (const run::ModeSwitch& change : turn.switches) modes[std::size_t(change.contact)] = change.to;
      hits += turn.hits;
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(TaylorRun, StopsAtImpulsesAndWherePulsesBeginAndEnd) {
  exact::modes::ModeCache modes;
  scene::Scene scene = test::cell_of({}).scene;
  scene.impulses.push_back({Eigen::Vector4d(0.02, 0.01, 0, 0), 3.1, 0.3});
  scene.pulses.at(0).duration_s = 0.02;
  // A second pulse that begins during the first kick and ends in the third turn.
  scene.pulses.push_back(scene.pulses.at(0));
  scene.pulses.at(1).elapsed_s = -0.011;
  scene.pulses.at(1).force_n *= -0.4;
  const auto exact = start_hybrid(scene, {}, modes);
  TaylorRun<4> run(scene, {});
  run::TurnReport a, b;
  for (int k = 0; k < 5; ++k) {
    ASSERT_EQ(run.advance({}, a), run::Outcome::ok);
    ASSERT_EQ(exact.advance({}, b), run::Outcome::ok);
    EXPECT_LT(largest_difference(a.section, b.section), 1e-12);
    EXPECT_EQ(a.hits, b.hits);
  }
}

TEST(TaylorRun, SaysWhatFailed) {
  run::SolverOptions few;
  few.max_steps_per_revolution = 3;
  run::TurnReport turn;
  EXPECT_EQ(TaylorRun<4>(test::cell_of({}).scene, few).advance({}, turn), run::Outcome::step_limit);
  scene::Scene lost = test::cell_of({}).scene;
  lost.displacement_m(0) = std::nan("");
  EXPECT_EQ(TaylorRun<4>(lost, {}).advance({}, turn), run::Outcome::non_finite);
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
