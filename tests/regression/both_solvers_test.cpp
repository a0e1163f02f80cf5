#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"
#include "support/map_cell.hpp"
#include "support/map_name.hpp"

namespace rubsweep {
namespace {

/// Every map of the repository by the exact and by the adaptive solver: these share only the scene and must
/// agree.
class BothSolvers : public testing::TestWithParam<std::string> {
 protected:
  sweep::Study study_ =
      config::read_run_config(std::filesystem::path(RUBSWEEP_CONFIGS) / (GetParam() + ".yaml"), {}).study;

  /// Index of the cell at these shares of both axes.
  std::size_t cell(double along_speed, double along_unbalance) const {
    return test::map_cell(study_.grid, along_speed, along_unbalance);
  }

  std::vector<double> section(std::size_t cell, const integrate::run::SolverOptions& solver,
                              int turns) const {
    const scene::Cell start = test::build_map_cell(study_, cell);
    EXPECT_EQ(start.start, scene::Start::quiet);
    integrate::exact::modes::ModeCache modes;
    const integrate::run::Run run = integrate::start(start.scene, solver, modes);
    integrate::run::TurnReport turn;
    bool touched = false;
    for (int k = 0; k < turns; ++k) {
      EXPECT_EQ(run.advance({}, turn), integrate::run::Outcome::ok);
      touched = touched || turn.touched;
    }
    EXPECT_TRUE(touched);
    return turn.section;
  }
};

TEST_P(BothSolvers, GiveTheSameSection) {
  integrate::run::SolverOptions exact = study_.solver, adaptive = study_.solver;
  exact.method = integrate::run::Method::exact;
  adaptive.method = integrate::run::Method::adaptive;
  exact.relative_tolerance = adaptive.relative_tolerance = 1e-12;
  for (const double place : {0.15, 0.4, 0.7}) {
    constexpr int turns = 6;
    const auto a = section(cell(place, 0.5), exact, turns), b = section(cell(place, 0.5), adaptive, turns);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-8) << place << ' ' << i;
  }
}

/// At most one of the three cells may differ, and only if a change of the kick by 1e-6 changes the class of
/// this cell, too.
TEST_P(BothSolvers, GiveTheSameClass) {
  sweep::Study adaptive = study_;
  study_.solver.method = integrate::run::Method::exact;
  adaptive.solver.method = integrate::run::Method::adaptive;
  adaptive.solver.relative_tolerance = 1e-10;
  adaptive.response.max_revolutions = study_.response.max_revolutions = 400;
  int different = 0;
  for (const double place : {0.1, 0.35, 0.6}) {
    response::motion::Workspace workspace;
    const sweep::Row a = evaluate_cell(study_, cell(place, 0.45), workspace),
                     b = evaluate_cell(adaptive, cell(place, 0.45), workspace);
    if (a.motion_class == b.motion_class && a.order == b.order) continue;
    ++different;
    sweep::Study kicked = study_;
    kicked.robustness = sweep::Robustness::on;
    EXPECT_EQ(evaluate_cell(kicked, cell(place, 0.45), workspace).robust, false) << place;
  }
  EXPECT_LE(different, 1);
}

INSTANTIATE_TEST_SUITE_P(OnEveryMap, BothSolvers,
                         testing::Values("minimal", "benchmark/one_side", "hard_case/one_side",
                                         "benchmark/both_sides", "benchmark/both_sides_unequal",
                                         "benchmark/annulus", "benchmark/annulus_offset", "reference_machine",
                                         "reference/figure11_annulus", "rotor_kit"),
                         [](const auto& test) { return test::name_of_map(test.param); });

}  // namespace
}  // namespace rubsweep
