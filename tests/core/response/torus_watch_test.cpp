#include "rubsweep/core/response/torus_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "core/response/golden_angle.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::response {
namespace {

/// Verdict of the watch on a made-up motion of four states, given by section and growth after each turn: the
/// revolutions at which it was called a torus, or those at which the watch ended.
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

TEST(TorusWatch, SeesATorusAtItsFirstLook) {
  const Watched seen = watch([](int k, auto& section) { turn_by(golden_angle, section, k); },
                             [](int k) { return 0.4 * std::cos(golden_angle * k); });
  EXPECT_TRUE(seen.torus);
  EXPECT_EQ(seen.revolutions, 300);
  EXPECT_EQ(seen.record_begin, 300);
}

TEST(TorusWatch, TakesNeitherPeriodsNorChaosNorSlowDecayForOne) {
  const auto uneven = [](int k) { return 0.4 * std::cos(golden_angle * k); };
  EXPECT_FALSE(watch([](int k, auto& s) { turn_by(2 * std::numbers::pi / 7, s, k); }, uneven).torus);
  EXPECT_FALSE(watch([](int k, auto& s) { turn_by(golden_angle, s, k, std::exp(-2e-3 * k)); }, uneven).torus);
  const auto on_a_circle = [](int k, std::vector<double>& s) { turn_by(golden_angle, s, k); };
  EXPECT_FALSE(watch(on_a_circle, [&](int k) { return uneven(k) - 4e-4; }).torus);
  EXPECT_FALSE(watch(on_a_circle, [&](int k) { return uneven(k) + 4e-4; }).torus);
}

/// Chaos ends no run, but its exponent is known at the end; where it stops on the way, it is none.
TEST(TorusWatch, KnowsChaosThatLastsToTheEnd) {
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
  // Too short to be told from a transient.
  growth_later = 0.1;
  EXPECT_FALSE(watch(wandering, growth_in, 1300).chaos);
  // A section that returns is periodic, whatever grows.
  const auto returning = [](int k, std::vector<double>& s) { turn_by(2 * std::numbers::pi / 7, s, k); };
  EXPECT_FALSE(watch(returning, growth_in).chaos);
}

TEST(TorusWatch, DoesNotBeginWhereItWouldSaveNothing) {
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

/// A rotor in an annular stop that is not round it: the watch ends the run sooner, with the verdict that the
/// whole run comes to.
TEST(TorusWatch, EndsARunWithTheVerdictOfAWholeOne) {
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
