#include "rubsweep/analysis/design/kick_threshold.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "analysis/design/study_of.hpp"
#include "core/scene/one_side_machine.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::design {
namespace {

const std::atomic<bool> never{false};

std::vector<KickThreshold> thresholds(const sweep::Study& study, double eccentricity_m,
                                      const std::vector<double>& speeds_hz, int threads = 1) {
  return kick_thresholds(study, scene::prepare_machine(study.machine), eccentricity_m, speeds_hz, threads,
                         never);
}

bool rubs(sweep::Study study, double eccentricity_m, double speed_hz, double force_n) {
  study.machine.kick->force_n = force_n;
  study.grid = sweep::grid_of({speed_hz, scene::Eccentricity{eccentricity_m}});
  response::motion::Workspace workspace;
  return response::motion::row_of(sweep::evaluate_cell(study, 0, workspace).motion_class).rubs;
}

TEST(KickThreshold, IsWhereRubBegins) {
  const sweep::Study study = study_of(scene::one_side_machine());
  const double eccentricity_m = 5e-4;
  const auto found = thresholds(study, eccentricity_m, {75, 90}, 2);
  ASSERT_EQ(found.size(), 2u);
  for (const KickThreshold& one : found) {
    ASSERT_TRUE(one.force_n) << one.speed_hz;
    EXPECT_TRUE(rubs(study, eccentricity_m, one.speed_hz, *one.force_n));
    EXPECT_FALSE(rubs(study, eccentricity_m, one.speed_hz, 0.989 * *one.force_n));
    EXPECT_FALSE(one.motion.empty());
    EXPECT_EQ(one.failed, 0u);
    EXPECT_GT(one.runs, 2u);
  }
}

TEST(KickThreshold, IsNothingWhereTheQuietMotionRubs) {
  const KickThreshold found = thresholds(study_of(scene::one_side_machine()), 2e-3, {90})[0];
  EXPECT_EQ(found.force_n, 0);
  EXPECT_EQ(found.runs, 1u);
}

TEST(KickThreshold, IsEmptyWhereNoKickDoes) {
  model::Machine machine = scene::one_side_machine();
  machine.kick->force_n = 1e-3;
  const KickThreshold found = thresholds(study_of(machine), 1e-4, {90})[0];
  EXPECT_FALSE(found.force_n);
  EXPECT_TRUE(found.motion.empty());
  EXPECT_EQ(found.runs, 8u) << "without a kick, and with seven";
}

}  // namespace
}  // namespace rubsweep::design
