#include "rubsweep/core/response/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::response {
namespace {

TEST(VerdictRecordedRun, HoldsTheLastTwoWindowsOfTheRun) {
  const scene::Cell cell = test::cell_of({});
  motion::ResponseOptions options;
  options.window_revolutions = 8;
  options.max_order = 4;
  motion::Workspace workspace;
  const auto record = recorded_run(cell.scene, {}, options, 21, workspace);
  ASSERT_TRUE(record);
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(cell.scene, {}, modes);
  integrate::run::TurnReport turn;
  for (int k = 0; k < 21; ++k) ASSERT_EQ(run.advance({}, turn), integrate::run::Outcome::ok);
  const motion::Window window = record->window(1);
  const auto last = window.section.last(static_cast<std::size_t>(window.states));
  for (std::size_t k = 0; k < last.size(); ++k) EXPECT_NEAR(last[k], turn.section[k], 1e-9) << k;
}

TEST(VerdictRecordedRun, IsNoneWhereATurnFails) {
  integrate::run::SolverOptions solver;
  solver.max_steps_per_revolution = 10;
  motion::Workspace workspace;
  EXPECT_FALSE(recorded_run(test::cell_of({}).scene, solver, {}, 128, workspace));
}

TEST(VerdictRecordedRun, CheckpointsAreAnEighthOfAWindowApart) {
  for (const int window : {16, 19, 2}) {
    const int spacing = (window + 7) / 8;
    Checkpoints passed(window, std::array{-1.0});
    for (int k = 1; k <= 10 * window; ++k) {
      passed.pass(k, std::array{static_cast<double>(k)});
      for (int back = 0; back <= std::min(k, 2 * window); ++back) {
        const auto& from = passed.before(k - back);
        EXPECT_EQ(from.revolutions, (k - back) / spacing * spacing) << window << ' ' << k << ' ' << back;
        EXPECT_EQ(from.section.front(), from.revolutions == 0 ? -1 : static_cast<double>(from.revolutions));
      }
    }
  }
}

}  // namespace

}  // namespace rubsweep::response
