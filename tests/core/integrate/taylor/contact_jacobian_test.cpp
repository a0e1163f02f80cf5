#include "rubsweep/core/integrate/taylor/contact_jacobian.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/annular_scene.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Mode;
using numerics::both;
using numerics::Twin;

constexpr int jacobian_order = 14;
constexpr std::size_t terms = jacobian_order;
const Twin none{};

ContactLaw law_with(double damping) {
  auto scene = test::annular_scene(1, 0, 1, 0, 0, 10, 0.1);
  ContactLaw law(run::scale<2>(scene).contacts[0]);
  law.stiffness = 10;
  law.damping = damping;
  law.slip_scale_m_per_s = 1;
  law.friction = contact::friction_terms(model::StribeckFriction{{0, 0, 0, 0.3, 1e4, 0}});
  return law;
}

/// Taylor coefficients of the contact force along a motion around the wall's centre with varying penetration,
/// displaced by `at_start` + phase * `growing`.
std::array<Twin, terms> forces(ContactSeries& series, const ContactLaw& law, Mode mode, Twin at_start,
                               Twin growing) {
  series.set_distance(Twin{1.1, -0.4} + at_start);
  series.begin(law, mode, 1, contact::Slip::forward);
  std::array<Twin, terms> force;
  for (int k = 0; k < jacobian_order; ++k) {
    const Twin rate = Twin{0.5 * std::sin(0.4 + k), 0.7 * std::cos(1.1 * k)} / both(std::tgamma(k + 1.0));
    series.set_velocity(k, rate + (k == 0 ? growing : Twin{}));
    force[static_cast<std::size_t>(k)] = series.force_term(k);
  }
  return force;
}

/// Constant and linearly growing displacements separate A and B: (B w)' + A w for linear w, minus that for
/// constant w.
TEST(ContactJacobian, IsTheDerivativeOfTheForce) {
  constexpr double small = 1e-5;
  for (const double damping : {0.0, 2.0}) {
    const ContactLaw law = law_with(damping);
    for (const Mode mode : {Mode::sprung, Mode::clamped, Mode::released}) {
      for (int axis = 0; axis < 2; ++axis) {
        const Twin along = axis == 0 ? Twin{1, 0} : Twin{0, 1}, step = both(small) * along;
        ContactSeries series;
        const auto staying_above = forces(series, law, mode, step, none),
                   staying_below = forces(series, law, mode, -step, none),
                   growing_above = forces(series, law, mode, none, step),
                   growing_below = forces(series, law, mode, none, -step);
        forces(series, law, mode, none, none);
        ContactJacobian jacobian;
        jacobian.follow(series);
        jacobian.extend(jacobian_order - 2);
        EXPECT_EQ(jacobian.damped(), law.damper(mode) != 0);
        const auto a = [&](int k) { return axis == 0 ? jacobian.first(k) : jacobian.second(k); };
        const auto b = [&](int k) {
          if (!jacobian.damped()) return Twin{};
          return axis == 0 ? jacobian.first_damped(k) : jacobian.second_damped(k);
        };
        for (int k = 0; k < jacobian_order - 1; ++k) {
          const auto at = static_cast<std::size_t>(k);
          const Twin staying = (staying_above[at] - staying_below[at]) / both(2 * small),
                     growing = (growing_above[at] - growing_below[at]) / both(2 * small);
          const Twin if_staying = both(k + 1) * b(k + 1) + a(k),
                     if_growing = both(k + 1) * b(k) + (k > 0 ? a(k - 1) : Twin{});
          for (int side = 0; side < 2; ++side) {
            EXPECT_NEAR(if_staying[side], staying[side], 1e-7 * (1 + std::abs(staying[side]))) << k;
            EXPECT_NEAR(if_growing[side], growing[side], 1e-7 * (1 + std::abs(growing[side]))) << k;
          }
        }
      }
    }
  }
}

/// Terms requested later equal those computed at once.
TEST(ContactJacobian, GoesOnWhereItWasLeft) {
  ContactSeries series;
  const ContactLaw law = law_with(2);
  forces(series, law, Mode::clamped, none, none);
  ContactJacobian at_once, in_two;
  at_once.follow(series);
  at_once.extend(9);
  in_two.follow(series);
  in_two.extend(3);
  in_two.extend(9);
  for (int k = 0; k <= 9; ++k) {
    for (int side = 0; side < 2; ++side) {
      EXPECT_EQ(at_once.first(k)[side], in_two.first(k)[side]);
      EXPECT_EQ(at_once.second_damped(k)[side], in_two.second_damped(k)[side]);
    }
  }
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
