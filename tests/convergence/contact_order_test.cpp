// Purpose of event location: with contact, a located stepper keeps the order that it has in flight, whereas
// smoothing adds an error that no tolerance removes.
#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "support/long_double_reference.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate {
namespace {

constexpr int turns = 6;

struct Point {
  double error = 0;      ///< largest scaled component of the section's error after 6 turns
  double rhs_calls = 0;  ///< calls of the right-hand side per turn
};

Point measure(const run::SolverOptions& options) {
  const test::OneSideRotor rotor;  // 75 Hz, whirl ratio 0.4: the 1/2 motion, three impacts in six turns
  static const auto reference = test::long_double_sections(rotor, turns);
  const run::Cursor advance = adaptive::start_adaptive(test::cell_of(rotor).scene, options);
  run::TurnReport turn;
  for (int k = 0; k < turns; ++k) EXPECT_EQ(advance({}, turn), run::Outcome::ok);
  return {test::section_error(turn.section, reference[turns], rotor),
          static_cast<double>(turn.effort.rhs_calls) / turns};
}

Point located(run::Stepper stepper, double tolerance) {
  run::SolverOptions options;
  options.stepper = stepper;
  options.relative_tolerance = tolerance;
  return measure(options);
}

Point smoothed(double tolerance, double width_m) {
  run::SolverOptions options;
  options.contact = run::ContactHandling::smoothed;
  options.relative_tolerance = tolerance;
  options.smoothing_m = width_m;
  return measure(options);
}

/// Convergence order: decades of error per decade of work.
double order_between(const Point& loose, const Point& tight) {
  return std::log(loose.error / tight.error) / std::log(tight.rhs_calls / loose.rhs_calls);
}

struct Order {
  double at_least = 0;
  double loose = 1e-7, tight = 1e-11;  ///< range of tolerances in which the order shows
};

/// Order of each stepper in flight, with a small margin. No default case, so that a new stepper must be
/// added.
Order order_of(run::Stepper stepper) {
  switch (stepper) {
    case run::Stepper::automatic:
    case run::Stepper::dopri5:
    case run::Stepper::cash_karp54: return {.at_least = 4.7};
    case run::Stepper::rkf78:
    case run::Stepper::bulirsch_stoer: return {.at_least = 7.5};
    case run::Stepper::rosenbrock4: return {.at_least = 3.6, .loose = 1e-6, .tight = 1e-9};
  }
  return {};
}

TEST(ContactOrder, LocatedKeepsTheOrderOfTheStepper) {
  for (const run::Stepper stepper : adaptive::single_steppers()) {
    const Order order = order_of(stepper);
    EXPECT_GT(order_between(located(stepper, order.loose), located(stepper, order.tight)), order.at_least)
        << adaptive::row_of(stepper).word;
  }
}

TEST(ContactOrder, SmoothedStopsAtItsOwnError) {
  const Point loose = smoothed(1e-10, 1e-7), tight = smoothed(1e-12, 1e-7);
  EXPECT_GT(tight.error, 1e-8);  // the located stepper reaches 1e-12 there
  EXPECT_NEAR(tight.error / loose.error, 1, 0.1);
  EXPECT_LT(located(run::Stepper::dopri5, 1e-12).error, 1e-3 * tight.error);
}

TEST(ContactOrder, SmoothingErrorGoesWithTheWidth) {
  const double ratio = smoothed(1e-12, 4e-7).error / smoothed(1e-12, 1e-7).error;
  EXPECT_GT(ratio, 3);   // order 1 at least: the error is proportional to the width
  EXPECT_LT(ratio, 20);  // order 2 at most: the error is proportional to the width squared
}

TEST(ContactOrder, LocatedNeedsFewerCallsThanThePlainStepper) {
  // Plain dopri5 without event location needs about 1450 calls per turn at 1e-6, with an error of about 1e-6.
  const Point point = located(run::Stepper::dopri5, 1e-6);
  EXPECT_LT(point.rhs_calls, 1450);
  EXPECT_LT(point.error, 4e-6);
}

}  // namespace
}  // namespace rubsweep::integrate
