#include "rubsweep/core/integrate/exact/modes/released_slip.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "rubsweep/core/numerics/modal_form.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

constexpr std::size_t released = 3;  // joint mode of a single contact

/// Samples the sliding rate over the longest step of the released mode and compares it with the bound at its
/// start.
TEST(ReleasedSlip, IsNeverExceededByTheMotion) {
  MachineModes<4> plan(test::cell_of({}).scene);
  const LinearMode<4>& mode = *plan.mode(released);
  const auto& system = plan.system();
  const auto form = numerics::modal_form(system.stiffness, system.damping);
  ASSERT_TRUE(form);
  const auto slip = released_slip({system, plan.friction(), form}, mode.modes, 0, mode.longest_step_s);
  ASSERT_TRUE(slip);
  Eigen::VectorXd start(8);
  // In contact by 0.01 clearances, moving away.
  start << 0.2, 1.01, 0, 0, 30, -50, 1, -2;
  const auto& c = system.contacts[0];
  const double penetration = c.first_row * start.head(4) - c.clearance;
  ASSERT_GT(penetration, 0);
  const Eigen::VectorXd z = form->inverse * start;
  double bound = 0;
  for (Eigen::Index j = 0; j < 4; ++j) bound += slip->sliding_rate_bound(j) * std::hypot(z(j), z(4 + j));
  Eigen::VectorXd offset = start;
  offset.head(4) -= mode.rest;
  double largest = 0;
  for (int i = 0; i <= 200; ++i) {
    const double t = mode.longest_step_s * i / 200;
    const Eigen::VectorXd rate = mode.generator * (numerics::matrix_flow(mode.generator, t) * offset);
    const double sliding_rate = std::abs(c.second_row * rate.tail(4));
    EXPECT_LE(sliding_rate, bound + (slip->friction_rate[0] + slip->friction_swing[0] * t) * penetration)
        << t;
    largest = std::max(largest, sliding_rate);
  }
  EXPECT_GT(largest, bound / 20);
}

TEST(ReleasedSlip, OpenContactsAddNoFriction) {
  MachineModes<4> plan(test::cell_of({}).scene);
  const auto& system = plan.system();
  const auto form = numerics::modal_form(system.stiffness, system.damping);
  const auto slip =
      released_slip({system, plan.friction(), form}, {contact::Mode::open}, 0, plan.mode(0)->longest_step_s);
  ASSERT_TRUE(slip);
  EXPECT_EQ(slip->friction_rate, std::vector<double>{0});
  EXPECT_EQ(slip->friction_swing, std::vector<double>{0});
}

}  // namespace
}  // namespace rubsweep::integrate::exact::modes
