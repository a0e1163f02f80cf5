#include "bench/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rubsweep/core/integrate/start.hpp"
#include "support/long_double_reference.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::bench {
namespace {

constexpr int turns = 6;

TEST(Reference, IsTheLongDoubleOneOnSetA) {
  const test::OneSideRotor rotor;
  const Reference reference = reference_section(test::cell_of(rotor).scene, turns, {});
  const auto by_hand = test::long_double_sections(rotor, turns, 1000);
  EXPECT_TRUE(reference.long_double);
  EXPECT_LT(test::section_error(reference.section, by_hand[turns], rotor), 2e-15);
  EXPECT_TRUE(reference.closed_forms);
  EXPECT_LT(uncertainty(reference), 5e-15);
  EXPECT_GT(reference.against_rkf78, 0);  // a different solver, so not exactly equal
  EXPECT_GT(reference.against_dopri5, 0);
}

TEST(Reference, OfARingIsMadeByAStepper) {
  model::Machine machine = test::machine_of({});
  machine.stops[0].geometry = model::AnnularGeometry{};
  const auto cell = scene::build_cell(machine, 75, scene::WhirlRatio{0.5});
  const Reference reference = reference_section(cell.scene, turns, {});
  EXPECT_FALSE(reference.closed_forms);
  EXPECT_TRUE(reference.long_double);
  EXPECT_LT(uncertainty(reference), 5e-15);
}

TEST(Reference, SaysWhatItIsWhereThereIsNoLongDouble) {
  model::Machine machine = test::machine_of({});
  machine.stops[0].friction = model::ConstantFriction{0.1};
  const auto cell = scene::build_cell(machine, 75, scene::WhirlRatio{0.4});
  const Reference reference = reference_section(cell.scene, turns, {});
  EXPECT_FALSE(reference.long_double);
  EXPECT_EQ(uncertainty(reference), std::max(reference.against_rkf78, reference.against_dopri5));
  EXPECT_LT(uncertainty(reference), 1e-9);
}

TEST(Reference, ExactRunsAreJudgedByLessThanTheStepperIsWrong) {
  const auto scene = test::cell_of({}).scene;
  const Reference reference = reference_section(scene, turns, {});
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(scene, {}, modes);
  integrate::run::TurnReport turn;
  for (int k = 0; k < turns; ++k) ASSERT_EQ(run.advance({}, turn), integrate::run::Outcome::ok);
  const double error = section_difference(turn.section, reference.section);
  EXPECT_LT(error, 2e-14);
  EXPECT_LT(10 * error, reference.against_rkf78);
}

TEST(Reference, TakesAnythingFromTheConfigurationButWhatItStatesItself) {
  integrate::run::SolverOptions base;
  base.contact = integrate::run::ContactHandling::smoothed;
  base.method = integrate::run::Method::adaptive;
  base.relative_tolerance = 1e-3;
  base.max_steps_per_revolution = 2'000'000;
  const auto options = reference_options(base);
  EXPECT_EQ(options.method, integrate::run::Method::automatic);
  EXPECT_EQ(options.stepper, integrate::run::Stepper::rkf78);
  EXPECT_EQ(options.contact, integrate::run::ContactHandling::located);
  EXPECT_EQ(options.relative_tolerance, reference_tolerance);
  EXPECT_EQ(options.max_steps_per_revolution, 2'000'000);
  base.max_steps_per_revolution = 4711;
  EXPECT_EQ(reference_options(base).max_steps_per_revolution, 1'000'000);
}

TEST(ReferenceSectionDifference, IsTheLargestAndSeesNotANumber) {
  const std::vector<double> a{1, -2, 3}, b{1.5, 0, 3};
  EXPECT_EQ(section_difference(a, b), 2);
  const std::vector<double> c{1, std::numeric_limits<double>::quiet_NaN(), 30};
  EXPECT_TRUE(std::isnan(section_difference(a, c)));
}

}  // namespace
}  // namespace rubsweep::bench
