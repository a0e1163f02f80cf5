#include "rubsweep/core/integrate/taylor/contact_tangent.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/annular_scene.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Mode;
using numerics::Twin;

constexpr int tangent_order = 16;

/// Taylor coefficient k of the velocity of a smooth motion, or of a change of it.
Twin motion_rate(int k) {
  return Twin{0.3 * std::cos(1.0 + k), 0.4 * std::sin(0.7 * k)} / std::tgamma(k + 1.0);
}
Twin change_rate(int k) { return Twin{std::sin(2.0 + k), std::cos(0.3 + 1.3 * k)} / std::tgamma(k + 1.0); }

/// Taylor coefficients of the force along the motion plus `share` times its change.
std::array<Twin, tangent_order> forces(ContactSeries& series, const ContactLaw& law, Mode mode, double slip,
                                       double share) {
  series.set_distance(Twin{1.3, 0.5} + numerics::both(share) * Twin{0.6, -0.8});
  series.begin(law, mode, slip, contact::Slip::forward);
  std::array<Twin, tangent_order> force;
  for (int k = 0; k < tangent_order; ++k) {
    series.set_velocity(k, motion_rate(k) + numerics::both(share) * change_rate(k));
    force[static_cast<std::size_t>(k)] = series.force_term(k);
  }
  return force;
}

ContactLaw law_of(bool annular, bool varies) {
  auto scene = test::annular_scene(1, 0, 1, 0, 0, 10, 0.1);
  ContactLaw law(run::scale<2>(scene).contacts[0]);
  law.annular = annular;
  law.stiffness = 10;
  law.damping = 2;
  law.slip_scale_m_per_s = 1;
  law.surface_speed_m_per_s = 0.2;
  law.friction =
      contact::friction_terms(varies ? model::Friction{model::StribeckFriction{{0, 0, 0, 0.3, 0.8, 0.05}}}
                                     : model::Friction{model::StribeckFriction{{0, 0, 0, 0.3, 1e4, 0}}});
  return law;
}

/// Taylor coefficients of the change of force, for the last of `Count` simultaneous vectors.
template <int Count>
std::array<Twin, tangent_order - 1> changes(const ContactSeries& series) {
  using Term = typename ContactTangents<Count>::Term;
  const auto fill = [](Twin last) {
    Term all;
    all.fill(Twin{0.3, 0.2});
    all.back() = last;
    return all;
  };
  ContactJacobian jacobian;
  jacobian.follow(series);
  ContactTangents<Count> tangents;
  tangents.follow(series, jacobian, tangent_order - 1);
  tangents.begin(fill(Twin{0.6, -0.8}));
  std::array<Twin, tangent_order - 1> force;
  for (int k = 0; k < tangent_order - 1; ++k)
    force[static_cast<std::size_t>(k)] = tangents.force_term(k, fill(change_rate(k))).back();
  return force;
}

/// Compares the change of force with the difference of two motions: for both kinds of wall, modes with and
/// without damper, and constant and varying friction. One vector alone and one of several are tested; several
/// share a Jacobian where there is one.
TEST(ContactTangents, IsTheDifferenceOfTwoMotions) {
  for (const bool annular : {false, true}) {
    for (const Mode mode : {Mode::sprung, Mode::clamped, Mode::released}) {
      for (const bool varies : {false, true}) {
        const ContactLaw law = law_of(annular, varies);
        ContactSeries series;
        // For constant friction only the sign of the sliding speed matters.
        const double slip = varies ? 0.1 : 1;
        constexpr double small = 1e-5;
        const auto later = forces(series, law, mode, slip, small),
                   earlier = forces(series, law, mode, slip, -small);
        forces(series, law, mode, slip, 0);
        EXPECT_EQ(series.friction_varies(), varies);
        const auto alone = changes<1>(series), beside_others = changes<tangents_together>(series);
        for (std::size_t k = 0; k < alone.size(); ++k) {
          for (int side = 0; side < 2; ++side) {
            const double expected = (later[k][side] - earlier[k][side]) / (2 * small);
            EXPECT_NEAR(alone[k][side], expected, 1e-7 * (1 + std::abs(expected)))
                << annular << varies << static_cast<int>(mode) << ' ' << k << ' ' << side;
            EXPECT_NEAR(beside_others[k][side], alone[k][side], 1e-13 * (1 + std::abs(expected)));
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
