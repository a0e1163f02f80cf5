// Series of the derivatives of a force against the derivatives of the law at states inside the step.
#include "rubsweep/core/integrate/taylor/regular_slopes.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/integrate/taylor/power_contact.hpp"
#include "rubsweep/core/integrate/taylor/series_options.hpp"

namespace rubsweep::integrate::taylor {
namespace {

constexpr int order = numerics::most_taylor_order;

numerics::Twin sum(const numerics::PlaneSeries& series, double s) {
  numerics::Twin all{};
  for (int k = order - 1; k >= 0; --k) all = all * numerics::both(s) + series[k];
  return all;
}

TEST(RegularSlopes, AreTheDerivativesOfTheLaw) {
  using Law = law::Dynamics<4, false>;
  for (const PowerContactCase& each : power_contact_cases()) {
    for (const double penetration : {0.002, 0.3}) {
      PowerContact<4> at(each);
      RegularExpansion<4> motion(at.system, rounding_of_series);
      ASSERT_TRUE(at.expand(motion, PowerContact<4>::state(penetration, 0.7)));
      RegularSlopes slopes;
      slopes.make(motion.contact(0), order);
      const double end = motion.converged() / 4;
      for (const double s : {0.0, 0.5 * end, end}) {
        std::vector<double> state(8);
        motion.put_state(s, state.data());
        Law::Matrix by_u, by_v, free_by_u, free_by_v;
        at.law.slopes(state, typename Law::Holding{}, by_u, by_v);
        at.law.modes()[0] = contact::Mode::open;
        at.law.slopes(state, typename Law::Holding{}, free_by_u, free_by_v);
        at.law.modes()[0] = each.mode;
        const auto& c = at.system.contacts[0];
        const auto matrix = [&](const numerics::Twin& first, const numerics::Twin& second) -> Law::Matrix {
          return (c.first_push * first[0] + c.second_push * first[1]) * c.first_row +
                 (c.first_push * second[0] + c.second_push * second[1]) * c.second_row;
        };
        numerics::Twin none{};
        const bool both = !slopes.only_first;
        const Law::Matrix u = matrix(sum(slopes.by[0], s), both ? sum(slopes.by[2], s) : none),
                          v = matrix(sum(slopes.by[1], s), both ? sum(slopes.by[3], s) : none);
        const double size = by_u.cwiseAbs().maxCoeff();
        EXPECT_LT((u - (by_u - free_by_u)).cwiseAbs().maxCoeff(), 1e-10 * size)
            << each.exponent << each.annular << penetration << " " << s;
        EXPECT_LT((v - (by_v - free_by_v)).cwiseAbs().maxCoeff(), 1e-10 * size)
            << each.exponent << each.annular << penetration << " " << s;
      }
    }
  }
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
