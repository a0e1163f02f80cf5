#include "rubsweep/core/response/aperiodic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/response/companion_growth.hpp"
#include "core/response/golden_angle.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::response {
namespace {

constexpr int window = 64;

/// Follows a map whose observed x is its first coordinate. `contact_ends`: number of turns after which there
/// is no contact.
Aperiodic follow(const proof::SectionMap& map, const std::vector<double>& state, int contact_ends = 1'000'000,
                 std::size_t turns_before = 0) {
  Eigen::Matrix<double, 2, Eigen::Dynamic> observed;
  observed.setZero(2, static_cast<Eigen::Index>(state.size() / 2));
  observed(0, 0) = 1;
  int turns = 0;
  spectrum::SpectrumWorkspace workspace;
  return classify_aperiodic(
      test::companion_growth(map, state), [&] { return ++turns <= contact_ends; }, state, turns_before,
      observed, window, workspace);
}

std::string name(const Aperiodic& found) { return std::string(to_string(found.motion_class)); }

bool henon(std::span<double> s) {
  const double x = s[0];
  s[0] = 1 - 1.4 * x * x + s[1];
  s[1] = 0.3 * x;
  return true;
}

/// Map that rotates by `angle` and is attracted by the unit circle; `stretch` > 0 makes the rotation uneven.
proof::SectionMap circle(double angle, double stretch) {
  return [=](std::span<double> s) {
    const double phi = std::atan2(s[1], s[0]), radius = std::hypot(s[0], s[1]);
    const double next = phi + angle + stretch * std::sin(phi);
    s[0] = (1 + 0.5 * (radius - 1)) * std::cos(next);
    s[1] = (1 + 0.5 * (radius - 1)) * std::sin(next);
    return true;
  };
}

/// A strongly attracting motion of period two with a rotating modulation that grows at `rate`.
proof::SectionMap modulated_period_two(double rate) {
  return [=](std::span<double> s) {
    s[0] = -s[0] * (1.5 - 0.5 * s[0] * s[0]);
    const double u = s[1], v = s[2], grow = std::exp(rate);
    s[1] = grow * (u * std::cos(golden_angle) - v * std::sin(golden_angle));
    s[2] = grow * (u * std::sin(golden_angle) + v * std::cos(golden_angle));
    s[3] *= 0.1;
    return true;
  };
}

TEST(AperiodicClassify, HenonsMapIsChaotic) {
  const Aperiodic found = follow(henon, {0.1, 0.2});
  EXPECT_EQ(name(found), "chaotic");
  EXPECT_NEAR(found.exponent.value().per_revolution, 0.41922, found.exponent->error_bar);
  EXPECT_FALSE(found.returns_after);
}

TEST(AperiodicClassify, ATorusIsQuasiPeriodic) {
  for (const double stretch : {0.0, 0.5, 0.9}) {
    const Aperiodic found = follow(circle(2 * std::numbers::pi * 0.381966, stretch), {0.6, 0.9});
    EXPECT_EQ(name(found), "quasi_periodic") << stretch;
    EXPECT_NEAR(found.exponent.value().per_revolution, 0, 1e-3);
  }
  EXPECT_EQ(name(follow(modulated_period_two(0), {0.9, 0.05, 0, 0.1})), "quasi_periodic");
}

/// Growth of the tangent vector along a motion that sticks (slow) for a tenth of each swing and slips (fast)
/// for the rest. The growth is bounded, so that the exponent is zero. Three turns contain almost 50 swings.
/// Seen every third turn the phase moves slowly, about once through a swing in the turns of a block. So all
/// blocks show the same trend of 0.022 a turn.
TEST(AperiodicClassify, SlowSwingsOfATangentVectorAreNeitherChaosNorDecay) {
  for (const double detuning : {0.0025, 0.0027, 0.0051, 0.0053}) {
    double phase = 0.05;
    const auto speed = [](double at) {
      const double place = at - std::floor(at);
      return place < 0.1 ? -4.0 : 1 + std::sin(9 * place);
    };
    const Growth growth = [&](std::span<double> section) -> std::optional<double> {
      const double before = speed(phase);
      phase += 50.0 / 3 + detuning;
      section[0] = std::cos(2 * std::numbers::pi * phase);
      section[1] = std::sin(2 * std::numbers::pi * phase);
      return speed(phase) - before;
    };
    const Eigen::Matrix<double, 2, Eigen::Dynamic> observed = Eigen::Vector2d(1, 0);
    spectrum::SpectrumWorkspace workspace;
    const Aperiodic found = classify_aperiodic(
        growth, [] { return true; }, {1, 0}, 0, observed, window, workspace);
    EXPECT_EQ(name(found), "quasi_periodic") << detuning;
  }
}

TEST(AperiodicClassify, AModulationThatStillDecaysIsUnsettled) {
  // The exponent is practically zero and the lines are constant: only the closest return shows the decay.
  const Aperiodic found = follow(modulated_period_two(-4e-4), {0.9, 0.05, 0, 0.1});
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_NEAR(found.exponent.value().per_revolution, -4e-4, 1e-6);
  EXPECT_FALSE(found.returns_after);
}

TEST(AperiodicClassify, ASlowDepartureIsNeitherChaosNorATorus) {
  const Aperiodic found = follow(modulated_period_two(8e-4), {0.9, 0.005, 0, 0.1});
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_GT(found.exponent.value().per_revolution, found.exponent->error_bar);
}

TEST(AperiodicClassify, ADecayThatIsAlmostOverIsUnsettledAtTheFirstLook) {
  int calls = 0;
  const auto map = [&calls, decay = modulated_period_two(-0.02)](std::span<double> s) {
    ++calls;
    return decay(s);
  };
  const Aperiodic found = follow(map, {0.9, 0.5, 0, 0.1});
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_NEAR(found.exponent.value().per_revolution, -0.02, 1e-4);
  EXPECT_EQ(calls, 2 * 640);
}

TEST(AperiodicClassify, ALongPeriodIsUnsettledAndNamed) {
  for (const int period : {14, 54, 127}) {
    const Aperiodic found = follow(circle(2 * std::numbers::pi / period, 0), {1, 0});
    EXPECT_EQ(name(found), "unsettled");
    EXPECT_EQ(found.returns_after, period);
  }
}

TEST(AperiodicClassify, ChaosThatEndsInAPeriodIsNotChaos) {
  // Both the base and its companion call the map, so 700 turns of chaos are 1400 calls.
  int calls = 0;
  const proof::SectionMap map = [&calls](std::span<double> s) {
    if (++calls <= 1400) return henon(s);
    for (double& x : s) x *= 0.5;
    return true;
  };
  const Aperiodic found = follow(map, {0.1, 0.2});
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_EQ(found.returns_after, 1);
  EXPECT_TRUE(found.left_chaos);
}

TEST(AperiodicClassify, TurnsOfTheRunCountForChaosButNotForItsExponent) {
  for (const auto& [turns_before, more] : {std::pair{0U, 1280}, {300U, 980}, {900U, 640}, {2000U, 640}}) {
    int calls = 0;
    const proof::SectionMap map = [&calls](std::span<double> s) {
      ++calls;
      return henon(s);
    };
    EXPECT_EQ(name(follow(map, {0.1, 0.2}, 1'000'000, turns_before)), "chaotic");
    EXPECT_EQ(calls, 2 * more) << turns_before;
  }
}

TEST(AperiodicClassify, ChaosThatLosesContactIsNotChaos) {
  const Aperiodic found = follow(henon, {0.1, 0.2}, 300);
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_FALSE(found.exponent);
  EXPECT_TRUE(found.left_chaos);
  EXPECT_EQ(name(follow(henon, {0.1, 0.2}, 1280)), "chaotic");
  // A motion that was never chaotic has not left chaos.
  EXPECT_FALSE(follow(circle(2 * std::numbers::pi / 14, 0), {1, 0}).left_chaos);
  EXPECT_FALSE(follow(modulated_period_two(0), {0.9, 0.05, 0, 0.1}, 300).left_chaos);
}

TEST(AperiodicClassify, AShorterPauseIsContact) {
  int turns = 0;
  Eigen::Matrix<double, 2, Eigen::Dynamic> observed(2, 1);
  observed << 1, 0;
  spectrum::SpectrumWorkspace workspace;
  const auto now_and_then = [&turns] { return ++turns % window == 0; };
  EXPECT_EQ(name(classify_aperiodic(test::companion_growth(henon, std::vector{0.1, 0.2}), now_and_then,
                                    {0.1, 0.2}, 0, observed, window, workspace)),
            "chaotic");
}

TEST(AperiodicClassify, AMapThatFailsLeavesNoExponent) {
  // The map fails after the first evaluation, which is undecided.
  int calls = 0;
  const proof::SectionMap map = [&calls](std::span<double> s) { return ++calls < 1500 && henon(s); };
  const Aperiodic found = follow(map, {0.1, 0.2});
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_FALSE(found.exponent);
}

TEST(AperiodicClassify, AModulationTooSmallToTellIsUnsettled) {
  EXPECT_EQ(name(follow(modulated_period_two(0), {0.9, 1e-3, 0, 0.1})), "quasi_periodic");
  // The section returns within 7e-5 after 8 turns, and within 1e-5 only after more turns than the first
  // evaluation covers.
  EXPECT_EQ(name(follow(modulated_period_two(0), {0.9, 2e-4, 0, 0.1})), "unsettled");
}

/// The torus of `modulated_period_two(0)`, with a companion that also grows by exp(growth(turn)) in a
/// coordinate that the motion itself does not use.
Aperiodic follow_with_growth(const std::function<double(int)>& growth, int& turns) {
  int calls = 0;
  const auto torus = modulated_period_two(0);
  const proof::SectionMap map = [&](std::span<double> s) {
    const double unused = s[3];
    torus(s);
    s[3] = unused * std::exp(growth(calls++ / 2));
    return true;
  };
  const Aperiodic found = follow(map, {0.9, 0.05, 0, 0});
  turns = calls / 2;
  return found;
}

TEST(AperiodicClassify, AnExponentWithAWideBarIsNotZero) {
  int turns = 0;
  // Waves longer than the blocks of any evaluation, so that each block has another mean.
  const auto slow = [](int turn) { return 0.05 * std::sin(2 * std::numbers::pi * turn / 400); };
  const Aperiodic found = follow_with_growth(slow, turns);
  EXPECT_LT(std::abs(found.exponent.value().per_revolution), found.exponent->error_bar);
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_EQ(turns, 2560);
}

TEST(AperiodicClassify, WhatOneLookLeavesOpenTheNextMayDecide) {
  int turns = 0;
  const auto early = [](int turn) { return turn < 500 ? 0.05 : 0; };
  EXPECT_EQ(name(follow_with_growth(early, turns)), "quasi_periodic");
  EXPECT_EQ(turns, 2560);
  EXPECT_EQ(name(follow_with_growth([](int) { return 0.0; }, turns)), "quasi_periodic");
  EXPECT_EQ(turns, 640);
}

TEST(AperiodicClassify, AReturnWhoseTrendIsUnknownIsNotDecided) {
  // Two modulations with a beat, which cancel in the middle of the first evaluation: there is no trend, but
  // the motion is unknown.
  constexpr double beat = 0.01, cancel = 384;
  int calls = 0;
  const proof::SectionMap map = [&](std::span<double> s) {
    const int whole = calls++ / 2;
    const double turn = whole;
    const double size = 0.1 * std::sin(beat * (turn - cancel));
    s[0] = -s[0] * (1.5 - 0.5 * s[0] * s[0]);
    s[1] = size * std::cos(turn);
    s[2] = size * std::sin(turn);
    // The companion keeps its distance: the exponent is zero.
    const double u = s[3], v = s[4];
    s[3] = u * std::cos(0.7) - v * std::sin(0.7);
    s[4] = u * std::sin(0.7) + v * std::cos(0.7);
    s[5] = 0;
    return true;
  };
  follow(map, {0.9, 0, 0, 1e-9, 0, 0});
  EXPECT_GT(calls, 2 * 640);
}

TEST(AperiodicClassify, BroadLinesAreNoTorus) {
  // A random walk on the circle, with the same steps for every state: zero exponent, but no lines.
  unsigned long bits = 1;
  int calls = 0;
  double step = 0;
  const proof::SectionMap map = [&](std::span<double> s) {
    if (++calls % 2 == 1) {
      bits = bits * 6364136223846793005UL + 1442695040888963407UL;
      step = 2 * std::numbers::pi * static_cast<double>(bits >> 11) * 0x1p-53;
    }
    return circle(step, 0)(s);
  };
  const Aperiodic found = follow(map, {1, 0});
  EXPECT_NEAR(found.exponent.value().per_revolution, 0, 1e-6);
  EXPECT_EQ(name(found), "unsettled");
}

/// Result of the watch on an artificial motion of four states, given by section and growth after each turn:
/// the revolution at which it detected a torus, or at which it ended.
struct Watched {
  long revolutions = 0;
  bool torus = false;
  long record_begin = 0;
  std::optional<motion::Exponent> chaos;
};

Watched watch(const std::function<void(int turn, std::vector<double>& section)>& section_after,
              const std::function<double(int turn)>& growth_in, int max_revolutions = 1500) {
  const scene::Scene scene = test::one_mass_scene(1, 1, 0.1, 1, 1);
  motion::ResponseOptions options;
  options.max_revolutions = max_revolutions;
  TorusWatch watch(scene, options, true);
  spectrum::SpectrumWorkspace workspace;
  integrate::run::TurnRequest request;
  integrate::run::TurnReport turn;
  turn.section.resize(4);
  turn.touched = true;
  for (int k = 0; k < max_revolutions; ++k) {
    watch.ask(k, request);
    turn.tangent_vectors.clear();
    if (request.tangent_vectors.cols() > 0)
      turn.tangent_vectors.fill(4, 1) = std::exp(growth_in(k)) * request.tangent_vectors;
    section_after(k, turn.section);
    watch.add(request, turn);
    if (k + 1 == watch.next_look() && watch.next_look() < max_revolutions) watch.look(workspace);
    if (watch.torus()) return {k + 1, true, watch.record_begin(), {}};
  }
  return {watch.next_look(), false, watch.record_begin(), watch.chaos()};
}

void turn_by(double angle, std::vector<double>& section, int k, double radius = 1) {
  section = {1 + radius * std::cos(angle * k), radius * std::sin(angle * k), 0, 0};
}

TEST(AperiodicTorusWatch, SeesATorusAtItsFirstLook) {
  const Watched seen = watch([](int k, auto& section) { turn_by(golden_angle, section, k); },
                             [](int k) { return 0.4 * std::cos(golden_angle * k); });
  EXPECT_TRUE(seen.torus);
  EXPECT_EQ(seen.revolutions, 300);
  EXPECT_EQ(seen.record_begin, 300);
}

TEST(AperiodicTorusWatch, TakesNeitherPeriodsNorChaosNorSlowDecayForOne) {
  const auto uneven = [](int k) { return 0.4 * std::cos(golden_angle * k); };
  EXPECT_FALSE(watch([](int k, auto& s) { turn_by(2 * std::numbers::pi / 7, s, k); }, uneven).torus);
  EXPECT_FALSE(watch([](int k, auto& s) { turn_by(golden_angle, s, k, std::exp(-2e-3 * k)); }, uneven).torus);
  const auto on_a_circle = [](int k, std::vector<double>& s) { turn_by(golden_angle, s, k); };
  EXPECT_FALSE(watch(on_a_circle, [&](int k) { return uneven(k) - 4e-4; }).torus);
  EXPECT_FALSE(watch(on_a_circle, [&](int k) { return uneven(k) + 4e-4; }).torus);
}

/// Chaos does not end a run, but its exponent is known at the end; if the chaos stops earlier, there is no
/// exponent.
TEST(AperiodicTorusWatch, KnowsChaosThatLastsToTheEnd) {
  int carried = 0;
  double growth_later = 0.1;
  const auto growth_in = [&](int k) {
    ++carried;
    return (k < 900 ? 0.1 : growth_later) + 0.4 * std::cos(golden_angle * k);
  };
  const auto wandering = [](int k, std::vector<double>& s) {
    turn_by(golden_angle, s, k, 1 + std::sin(0.3 * k * k));
  };
  const Watched seen = watch(wandering, growth_in);
  EXPECT_FALSE(seen.torus);
  EXPECT_EQ(seen.revolutions, 1500);
  EXPECT_EQ(seen.record_begin, 1500 - 2 * 64);
  EXPECT_EQ(carried, 1400);
  ASSERT_TRUE(seen.chaos);
  EXPECT_NEAR(seen.chaos->per_revolution, 0.1, 1e-3);
  growth_later = 0;
  EXPECT_FALSE(watch(wandering, growth_in).chaos);
  // The chaos is too short to differ from a transient.
  growth_later = 0.1;
  EXPECT_FALSE(watch(wandering, growth_in, 1300).chaos);
  // A section that returns is periodic, whatever the growth is.
  const auto returning = [](int k, std::vector<double>& s) { turn_by(2 * std::numbers::pi / 7, s, k); };
  EXPECT_FALSE(watch(returning, growth_in).chaos);
}

TEST(AperiodicTorusWatch, DoesNotBeginWhereItWouldSaveNothing) {
  int carried = 0;
  const Watched seen = watch([](int k, auto& section) { turn_by(golden_angle, section, k); },
                             [&](int) {
                               ++carried;
                               return 0.0;
                             },
                             400);
  EXPECT_FALSE(seen.torus);
  EXPECT_EQ(carried, 0);
}

/// A rotor in an eccentric annular stop: the watch ends the run early with the verdict of the whole run.
TEST(AperiodicTorusWatch, EndsARunWithTheVerdictOfAWholeOne) {
  test::OneSideRotor rotor;
  rotor.stiffness_n_per_m = 5e6;
  rotor.restitution = 0.5;
  rotor.casing_stiffness_n_per_m = 2e5;
  rotor.casing_damping_ratio = 0.4;
  rotor.friction_coefficient = 0.02;
  rotor.kick_n = 45;
  model::Machine machine = test::machine_of(rotor);
  machine.stops[0].geometry = model::AnnularGeometry{{0, 2.5e-4}};
  const scene::Cell cell = scene::build_cell(machine, 120, scene::WhirlRatio{0.93});
  motion::Workspace workspace;
  motion::ResponseOptions options;
  options.max_revolutions = 1500;
  const SettledRun watched = settle(cell, {}, options, workspace);
  options.floquet_proof = false;
  const SettledRun whole = settle(cell, {}, options, workspace);
  EXPECT_EQ(whole.revolutions, 1500);
  EXPECT_LT(watched.revolutions, 1000);
  EXPECT_EQ(watched.motion.motion_class, motion::MotionClass::quasi_periodic);
  EXPECT_EQ(whole.motion.motion_class, motion::MotionClass::quasi_periodic);
  EXPECT_NEAR(watched.motion.measures.amplitude_1x_forward_m, whole.motion.measures.amplitude_1x_forward_m,
              0.02 * whole.motion.measures.amplitude_1x_forward_m);
  EXPECT_LT(std::abs(watched.motion.exponent.value().per_revolution), 2e-3);
}

}  // namespace

}  // namespace rubsweep::response
