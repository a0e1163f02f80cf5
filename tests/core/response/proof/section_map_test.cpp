#include "rubsweep/core/response/proof/section_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "core/integrate/curved_machine.hpp"
#include "core/response/companion_growth.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/response/followed.hpp"
#include "rubsweep/core/response/lyapunov_exponent.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::response::proof {
namespace {

/// Section of the rotor after some turns.
std::vector<double> section_after(const scene::Scene& scene, int turns,
                                  const integrate::run::SolverOptions& solver) {
  const integrate::run::Cursor cursor = integrate::adaptive::start_adaptive(scene, solver);
  integrate::run::TurnReport turn;
  for (int k = 0; k < turns; ++k) EXPECT_EQ(cursor({}, turn), integrate::run::Outcome::ok);
  return turn.section;
}

/// Every turn counts against the budget, for solvers that count from the start or from a restart.
TEST(SectionMapScene, EndsWithItsBudget) {
  const auto cell = test::cell_of({});
  integrate::exact::modes::ModeCache modes;
  for (const auto method : {integrate::run::Method::exact, integrate::run::Method::adaptive}) {
    integrate::run::SolverOptions solver;
    solver.method = method;
    integrate::run::WorkBudget endless(1e12), of_six_turns(0);
    SceneMap map(cell.scene, solver, modes, &endless);
    std::vector<double> section = section_after(cell.scene, 3, {});
    const std::vector<double> start = section;
    for (int turn = 0; turn < 6; ++turn) ASSERT_TRUE(map(section));
    const double spent = 1e12 - endless.left();
    EXPECT_GT(spent, 0);
    of_six_turns = integrate::run::WorkBudget(spent);
    SceneMap limited(cell.scene, solver, modes, &of_six_turns);
    section = start;
    for (int turn = 0; turn < 6; ++turn) EXPECT_TRUE(limited(section)) << turn;
    EXPECT_FALSE(limited(section));
  }
}

/// A continued motion differs from one that starts afresh at every section by rounding alone. From any other
/// section it starts afresh.
TEST(SectionMapScene, GoesOnAsItWouldStartAfresh) {
  const auto cell = test::cell_of({});
  integrate::exact::modes::ModeCache modes;
  SceneMap map(cell.scene, {}, modes);
  std::vector<double> afresh = section_after(cell.scene, 3, {}), continued = afresh;
  const std::vector<double> start = afresh;
  std::vector<std::vector<double>> sections;
  for (int turn = 0; turn < 20; ++turn) {
    ASSERT_TRUE(map(afresh));
    sections.push_back(afresh);
  }
  int equal_bits = 0;
  for (const std::vector<double>& section : sections) {
    ASSERT_TRUE(map.go_on(continued));
    equal_bits += continued == section;
    for (std::size_t i = 0; i < section.size(); ++i) EXPECT_NEAR(continued[i], section[i], 1e-9) << i;
  }
  EXPECT_GE(equal_bits, 1);  // the first turn starts afresh in both
  EXPECT_LT(equal_bits, 20);
  continued = start;
  ASSERT_TRUE(map.go_on(continued));
  EXPECT_EQ(continued, sections.front());
}

/// A section in contact does not contain the speed at which the contact began, which determines the following
/// turn.
TEST(SectionMapScene, AContactDampedByItsOwnImpactIsFollowedInTheAirAlone) {
  namespace curved = integrate::test_curved;
  const integrate::run::SolverOptions solver{.relative_tolerance = 1e-12};
  int open = 0, touching = 0, compared = 0;
  for (int angle_deg = 0; angle_deg < 360; angle_deg += 45) {
    scene::Contact wall;
    wall.wall = contact::FlatWall{contact::direction(angle_deg)};
    wall.clearance_m = 5e-4;
    curved::give_law(curved::power_stop(1e6, 1.5, model::ImpactDamping::hunt_crossley, 0.5), wall);
    const scene::Scene scene = curved::rotor_and_casing({wall}, 60);
    const integrate::run::Cursor cursor = integrate::adaptive::start_adaptive(scene, solver);
    integrate::exact::modes::ModeCache modes;
    SceneMap map(scene, solver, modes);
    integrate::run::TurnReport turn;
    bool decides = false;
    for (int k = 0; k < 20; ++k) {
      const std::vector<double> start = turn.section;
      ASSERT_EQ(cursor({}, turn), integrate::run::Outcome::ok);
      if (!std::exchange(decides, !turn.touching_at_end)) continue;
      std::vector<double> section = start;
      Eigen::MatrixXd moved = Eigen::MatrixXd::Identity(8, 8);
      EXPECT_EQ(map.carry(section, moved), decides) << k;
      ++(decides ? open : touching);
      if (!decides) continue;
      for (std::size_t i = 0; i < section.size(); ++i) EXPECT_NEAR(section[i], turn.section[i], 1e-8);
      if (turn.hits == 0 || k % 5 != 0) continue;
      constexpr double by = 1e-6;
      std::vector<double> ahead = start, behind = start;
      ahead[5] += by, behind[5] -= by;
      if (!map(ahead) || !map(behind)) continue;
      ++compared;
      for (std::size_t j = 0; j < section.size(); ++j)
        EXPECT_NEAR(moved(Eigen::Index(j), 5), (ahead[j] - behind[j]) / (2 * by), 1e-4 * moved.norm()) << k;
    }
  }
  EXPECT_GT(open, 10);
  EXPECT_GT(touching, 2);
  EXPECT_GT(compared, 2);
}

TEST(SectionMapScene, RepeatsTheTurnsOfARun) {
  const auto cell = test::cell_of({});
  integrate::run::SolverOptions solver;
  solver.relative_tolerance = 1e-11;
  integrate::exact::modes::ModeCache modes;
  SceneMap map(cell.scene, solver, modes);
  std::vector<double> section = section_after(cell.scene, 3, solver);
  for (int turn = 4; turn <= 12; ++turn) {
    ASSERT_TRUE(map(section));
    const auto expected = section_after(cell.scene, turn, solver);
    for (std::size_t i = 0; i < section.size(); ++i) EXPECT_NEAR(section[i], expected[i], 1e-7) << turn;
  }
}

TEST(SectionMapScene, HasNoMemoryAndNoPulse) {
  const auto cell = test::cell_of({});
  integrate::exact::modes::ModeCache modes;
  SceneMap map(cell.scene, {}, modes);
  // The quiet motion stays on its circle, because nothing kicks it.
  const auto quiet = integrate::run::scaled_initial_state(cell.scene);
  auto section = quiet;
  ASSERT_TRUE(map(section));
  EXPECT_FALSE(map.touched());
  for (std::size_t i = 0; i < section.size(); ++i) EXPECT_NEAR(section[i], quiet[i], 1e-7);

  const auto kicked = section_after(cell.scene, 2, {});
  auto first = kicked, second = kicked;
  ASSERT_TRUE(map(first));
  EXPECT_TRUE(map.touched());
  for (int k = 0; k < 3; ++k) map(section);
  ASSERT_TRUE(map(second));
  EXPECT_EQ(first, second);
}

TEST(SectionMapScene, SaysWhenTheSolverFailsAndRefusesOtherSections) {
  const auto cell = test::cell_of({});
  integrate::run::SolverOptions solver;
  solver.max_steps_per_revolution = 1;
  integrate::exact::modes::ModeCache modes;
  SceneMap map(cell.scene, solver, modes);
  std::vector<double> section(8);
  EXPECT_FALSE(map(section));
  section.pop_back();
  EXPECT_THROW(map(section), SolverError);
}

TEST(SectionMapScene, ExponentOfTheHalfSubharmonicIsTheDecayOfItsTangentialMotion) {
  // Along a wall at 90 degrees, x is a linear oscillator that the normal motion drives, without feedback. It
  // decays by zeta omega0 T per turn, slower than everything else in this orbit, for every tolerance.
  const test::OneSideRotor rotor;
  const auto cell = test::cell_of(rotor);
  const double expected =
      -2 * std::numbers::pi * rotor.damping_ratio * rotor.natural_frequency_hz / rotor.speed_hz;
  for (const double tolerance : {1e-6, 1e-7, 1e-8}) {
    integrate::run::SolverOptions solver;
    solver.relative_tolerance = tolerance;
    integrate::exact::modes::ModeCache modes;
    SceneMap map(cell.scene, solver, modes);
    const auto exponent = test::largest_exponent(std::ref(map), section_after(cell.scene, 400, solver), 400);
    ASSERT_TRUE(exponent);
    EXPECT_NEAR(exponent->per_revolution, expected, exponent->error_bar) << tolerance;
    EXPECT_LT(exponent->error_bar, 0.002);
  }
}

TEST(SectionMapScene, ExponentIsTheRateAtWhichSectionsApproachTheirOrbit) {
  const auto cell = test::cell_of({});
  integrate::run::SolverOptions solver;
  solver.relative_tolerance = 1e-10;
  integrate::exact::modes::ModeCache modes;
  SceneMap map(cell.scene, solver, modes);
  std::vector<double> rows, section = section_after(cell.scene, 40, solver);
  for (int k = 0; k < 180; ++k) {
    ASSERT_TRUE(map(section));
    rows.insert(rows.end(), section.begin(), section.end());
  }
  const auto nearest = closest_return(rows, 8, 8);
  EXPECT_EQ(nearest.order % 2, 0);
  const auto exponent = test::largest_exponent(std::ref(map), section, 400);
  EXPECT_NEAR(nearest.rate, exponent.value().per_revolution, nearest.rate_error_bar + exponent->error_bar);
  EXPECT_LT(nearest.rate_error_bar, 0.005);
}

}  // namespace
}  // namespace rubsweep::response::proof
