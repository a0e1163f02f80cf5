#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "rubsweep/maps/config/run_config.hpp"
#include "support/long_double_errors.hpp"
#include "support/map_cell.hpp"
#include "support/map_name.hpp"

namespace rubsweep {
namespace {

/// One cell of every kind of map in the repository, compared with a run in long double that shares only the
/// scene and the contact law's table of modes. studies/accuracy/every_scene compares more cells.
class LongDouble : public testing::TestWithParam<std::string> {};

TEST_P(LongDouble, HasTheSameSectionAndMonodromyMatrix) {
  const sweep::Study study =
      config::read_run_config(std::filesystem::path(RUBSWEEP_CONFIGS) / (GetParam() + ".yaml"), {}).study;
  const scene::Cell cell = test::build_map_cell(study, test::map_cell(study.grid, 0.4, 0.3));
  ASSERT_EQ(cell.start, scene::Start::quiet);
  const test::LongDoubleErrors errors = test::errors_against_long_double(cell.scene, study.solver, 6);
  EXPECT_TRUE(errors.touched);
  EXPECT_LE(errors.section, 1e-12);
  EXPECT_LE(errors.monodromy, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(OnEveryKindOfMap, LongDouble,
                         testing::Values("minimal", "benchmark/one_side", "hard_case/one_side",
                                         "benchmark/both_sides", "benchmark/both_sides_unequal",
                                         "benchmark/annulus", "benchmark/annulus_offset",
                                         "light_casing/annulus", "reference_machine",
                                         "reference/figure09_both_sides", "reference/figure11_annulus",
                                         "reference/figure12_annulus_offset"),
                         [](const auto& test) { return test::name_of_map(test.param); });

}  // namespace
}  // namespace rubsweep
