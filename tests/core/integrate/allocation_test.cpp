#include <gtest/gtest.h>

#include <Eigen/Core>
#include <atomic>
#include <cstddef>

#include "core/integrate/rubbing_kit.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/annular_scene.hpp"
#include "support/set_a_cell.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define RUBSWEEP_FOREIGN_MALLOC
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define RUBSWEEP_FOREIGN_MALLOC
#endif

#if defined(__GLIBC__) && !defined(RUBSWEEP_FOREIGN_MALLOC)

namespace {
std::atomic<long> allocations{0};
}

extern "C" void* __libc_malloc(std::size_t size);

/// Eigen calls malloc instead of operator new, so malloc counts the allocations.
extern "C" void* malloc(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}

namespace rubsweep::integrate {
namespace {

/// Allocations over several turns with all kinds of observation, after first turns have prepared the run.
long allocations_of(const scene::Scene& scene, const run::SolverOptions& options, bool by_series = false) {
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, options, modes);
  run::TurnRequest asked;
  run::TurnReport turn;
  asked.peaks = true;
  asked.samples_per_revolution = 32;
  const Eigen::Index states = 2 * scene.structure.coordinates();
  asked.tangent_vectors.setIdentity(states, states);
  const auto advance = [&](int turns) {
    int hits = 0;
    for (int k = 0; k < turns; ++k) {
      EXPECT_EQ(run.advance(asked, turn), run::Outcome::ok);
      hits += turn.hits;
    }
    return hits;
  };
  advance(30);
  const long before = allocations;
  EXPECT_GT(advance(30), 2);
  EXPECT_EQ(turn.effort.adaptive_turns, 0);
  EXPECT_EQ(turn.effort.taylor_turns > 0, by_series);
  return allocations - before;
}

TEST(Allocation, CountsWhatIsAllocated) {
  const long before = allocations;
  Eigen::VectorXd room(100);
  room.setZero();
  EXPECT_EQ(room.sum(), 0);
  EXPECT_EQ(allocations - before, 1);
}

TEST(Allocation, NoneInTheTimeLoopOfTheExactSolver) {
  EXPECT_EQ(allocations_of(test::cell_of({}).scene, {}), 0);
  EXPECT_EQ(allocations_of(kit_scene(70, 0.7), {}), 0);
}

/// Three pulses act all the time, after the kick.
TEST(Allocation, NoneWhilePulsesAct) {
  scene::Scene scene = test::cell_of({}).scene;
  for (int k = 0; k < 3; ++k) {
    scene::Pulse pulse = scene.pulses.front();
    pulse.force_n = 1 + k;
    pulse.duration_s = (80 + k) * scene.period_s();
    pulse.elapsed_s = -0.3 * k * scene.period_s();
    scene.pulses.push_back(pulse);
  }
  EXPECT_EQ(allocations_of(scene, {}), 0);
}

TEST(Allocation, NoneInTaylorPieces) {
  // Elastic contacts keep the rotor in touch: an annular stop, and a flat stop whose friction never
  // saturates.
  scene::Scene annular = test::annular_scene(1, 0, 1.3, 0.4, 0, 40, 0);
  test::start_at(annular, 0.5, {0.3, 0.8});
  EXPECT_EQ(allocations_of(annular, {}, true), 0);
  scene::Scene viscous = test::cell_of({}).scene;
  viscous.contacts[0].friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 1e-4}};
  EXPECT_EQ(allocations_of(viscous, {}, true), 0);
}

TEST(Allocation, NoneInTheTimeLoopOfDopri5) {
  run::SolverOptions dopri5;
  dopri5.method = run::Method::adaptive;
  dopri5.stepper = run::Stepper::dopri5;
  EXPECT_EQ(allocations_of(test::cell_of({}).scene, dopri5), 0);
}

}  // namespace
}  // namespace rubsweep::integrate

#endif
