#include "rubsweep/core/integrate/exact/modes/mode_views.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_flow.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

using Modes = MachineModes<4>;
using State = LinearMode<4>::State;

const State start{{0.3, -0.2, 0.1, 0.05, 200, 90, -300, 700}};

State after(const LinearMode<4>& mode, double time_s) {
  State free = mode.to_free(start);
  move_pairs(flow_of_pairs(mode, time_s), free);
  return free;
}

/// Checks guards and forces of the free vibration over a step: the value equals the row times (u, u'), the
/// rate is its derivative, and the second derivative stays within the bound.
void expect_sum_of(const LinearMode<4>& mode, const ModalTerms& terms, const Eigen::RowVectorXd& physical) {
  const double step = mode.longest_step_s, small = 1e-4 * step;
  const auto value = [&](double time_s) {
    const State free = after(mode, time_s);
    return sum_of(terms.list, free.data(), true).value();
  };
  const ModalSum sum = sum_of(terms.list, mode.to_free(start).data(), true);
  EXPECT_NEAR(sum.value(), physical.dot(start.transpose()), 1e-12 * physical.norm() * start.norm());
  const double slope = (value(small) - value(-small)) / (2 * small);
  EXPECT_NEAR(sum.rate(), slope, 1e-5 * std::abs(slope) + 1e-9);
  double largest = 0;
  for (int k = 0; k <= 200; ++k) {
    const double at = step * k / 200;
    largest = std::max(largest, std::abs(value(at + small) - 2 * value(at) + value(at - small)));
  }
  largest /= small * small;
  EXPECT_LE(largest, 1.001 * sum.curvature());
  EXPECT_GT(largest, 1e-3 * sum.curvature());
}

TEST(ModeViews, GuardsAndForcesAreThoseOfTheState) {
  Modes modes(test::cell_of({}).scene);
  int guards = 0, touches = 0;
  for (std::size_t joint = 0; joint < 4; ++joint) {
    const LinearMode<4>* mode = modes.mode(joint);
    ASSERT_TRUE(mode);
    if (!mode->paired) continue;
    for (const auto& guard : mode->guards) {
      expect_sum_of(*mode, guard.terms, guard.physical);
      ++guards;
    }
    for (const auto& touch : mode->touches) {
      if (touch.pushes) expect_sum_of(*mode, touch.force_of_free, touch.force);
      ++touches;
    }
  }
  EXPECT_GE(guards, 3);
  EXPECT_GE(touches, 2);
}

/// At rest a guard equals its constant: the parts of the clearance and of the rest position.
TEST(ModeViews, ConstantsAreThoseOfTheRest) {
  const scene::Scene scene = test::cell_of({}).scene;
  Modes modes(scene);
  const LinearMode<4>& open = *modes.mode(0);
  ASSERT_EQ(open.guards.size(), 1U);
  const auto& guard = open.guards[0];
  const double clearance = modes.system().contacts[0].clearance;
  EXPECT_NEAR(guard.constant, guard.physical.head(4).dot(open.rest.transpose()) - clearance, 1e-14);
  ASSERT_EQ(open.closing.size(), 1U);
  ASSERT_EQ(open.casings.size(), 1U);
}

}  // namespace
}  // namespace rubsweep::integrate::exact::modes
