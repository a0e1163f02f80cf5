// Reference trajectory of Modelica.Mechanics.Translational.Examples.ElastoGap by Dymola, from the reference
// results of the Modelica Association (MAP-LIB): m = 1 kg, s(0) = 2 m, v(0) = 0, walls at |s| = 0.5 m, c = 10
// N/m, d = 1.5 N s/m. elastoGap1.v_rel is ds/dt, elastoGap2.s_rel is 2 - s.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "maps/batch/read_csv.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

scene::Scene elastogap_scene() {
  scene::Scene scene = test::one_mass_scene(1, 0, 0, 1, 0.5);
  scene.contacts.push_back(test::wall_across_x(1, 0.5, 10, 1.5));
  scene.contacts.push_back(test::wall_across_x(-1, 0.5, 10, 1.5));
  scene.displacement_m << 2, 0;
  return scene;
}

struct Deviation {
  double speed_m_per_s = 0;
  double position_m = 0;
};

Deviation from_reference(const run::SolverOptions& options) {
  const auto table = batch::read_csv(std::string(RUBSWEEP_SUPPORT_DATA) + "/elastogap_dymola_reference.csv");
  const auto time = batch::column(table, "time");
  const auto speed = batch::column(table, "elastoGap1.v_rel");
  const auto distance = batch::column(table, "elastoGap2.s_rel");
  const scene::Scene scene = elastogap_scene();
  const double unit_speed = scene.length_scale_m * scene.speed_rad_per_s;
  constexpr int per_second = 200;  // the reference has one row every 5 ms
  const run::Cursor advance = adaptive::start_adaptive(scene, options);
  run::TurnRequest asked;
  run::TurnReport turn;
  asked.samples_per_revolution = per_second;
  Deviation worst;
  std::size_t row = 0;
  for (int second = 0; row < table.rows.size(); ++second) {
    EXPECT_EQ(advance(asked, turn), run::Outcome::ok);
    for (int k = 0; k < per_second; ++k) {
      const double t = second + double(k) / per_second;
      // Dymola adds rows at events; only rows at multiples of 5 ms are compared.
      while (row < table.rows.size() && batch::number(table, row, time) < t - 1e-9) ++row;
      if (row >= table.rows.size() || std::abs(batch::number(table, row, time) - t) > 1e-9) continue;
      const double* state = turn.samples.data() + 4 * k;
      worst.speed_m_per_s =
          std::max(worst.speed_m_per_s, std::abs(state[2] * unit_speed - batch::number(table, row, speed)));
      worst.position_m = std::max(worst.position_m, std::abs(2 - state[0] * scene.length_scale_m -
                                                             batch::number(table, row, distance)));
    }
    if (second > 60) break;
  }
  return worst;
}

// All steppers agree with each other within 1e-7 m/s. Each differs from the reference by 3.11e-5 m/s at t =
// 1.02 s, which is the integration error of the reference.
constexpr double reference_error_m_per_s = 3.12e-5;

TEST(ElastoGapReference, EveryStepperMeetsIt) {
  for (const run::Stepper stepper : adaptive::single_steppers()) {
    run::SolverOptions options;
    options.stepper = stepper;
    options.relative_tolerance = stepper == run::Stepper::rosenbrock4 ? 1e-8 : 1e-10;
    const Deviation worst = from_reference(options);
    EXPECT_LT(worst.speed_m_per_s, reference_error_m_per_s) << adaptive::row_of(stepper).word;
    EXPECT_LT(worst.position_m, 1e-5) << adaptive::row_of(stepper).word;
  }
}

TEST(ElastoGapReference, SmoothedMeetsItToo) {
  run::SolverOptions options;
  options.contact = run::ContactHandling::smoothed;
  options.smoothing_m = 1e-5;
  EXPECT_LT(from_reference(options).speed_m_per_s, 1.1 * reference_error_m_per_s);
}

}  // namespace
}  // namespace rubsweep::integrate
