// The series of a force by a power against the binomial series, and against the law itself.
#include "rubsweep/core/integrate/taylor/regular_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/integrate/curved_machine.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using namespace test_curved;

TEST(RegularContact, KnowsHalvesOfIntegers) {
  for (const double exponent : {1.0, 1.5, 2.0, 2.5, 3.0}) {
    const contact::CurvedLaw law(power_stop(1e6, exponent));
    const PowerLaw power(&law, 2e-3);
    EXPECT_EQ(power.halves, 2 * exponent);
    EXPECT_EQ(power.rooted(), exponent == 1.5 || exponent == 2.5);
    EXPECT_NEAR(power.force_n(0.3) / law.force_n(0.3 * 2e-3), 1, 1e-14);
    EXPECT_NEAR(power.slope(0.3) / (2e-3 * law.slope_n_per_m(0.3 * 2e-3)), 1, 1e-14);
  }
  const contact::CurvedLaw other(power_stop(1e6, 1.3));
  EXPECT_EQ(PowerLaw(&other, 1e-3).halves, 0);
  EXPECT_EQ(PowerLaw(nullptr, 1e-3).halves, 0);
}

/// Along the penetration p + v t the force is K (p + v t)^n (1 + c v), away from p = 0.
TEST(RegularContact, ForceIsABinomialSeries) {
  constexpr double p = 0.4, v = 0.3, c = 0.7, clearance = 1;
  for (const double exponent : {1.0, 1.5, 2.0, 2.5, 3.0}) {
    scene::Scene scene = test::one_mass_scene(2, 0, 0, 1, 1e-3);
    scene.contacts.push_back(test::wall_across_x(1, 1e-3, 1, 0));
    give_law(power_stop(1e6, exponent), scene.contacts[0]);
    const auto system = run::scale<2>(scene);
    const ContactLaw law(system.contacts[0]);
    RegularContact contact(PowerLaw(system.contacts[0].law.get(), 1e-3));
    contact.begin(law, contact::Mode::sprung, 1, contact::Slip::forward);
    contact.begin_power(c, false);
    double expected = contact.power().force_n(p);
    for (int k = 0; k < 20; ++k) {
      const double distance = k == 0 ? clearance + p : k == 1 ? v : 0;
      contact.set_distance(k, numerics::Twin{distance, 0});
      contact.set_velocity(k, numerics::Twin{k == 0 ? v : 0, 0});
      EXPECT_NEAR(contact.power_term(k)[0], expected * (1 + c * v), 1e-13 * contact.power().force_n(p)) << k;
      contact.advance(k, nullptr);
      expected *= (exponent - k) / (k + 1) * v / p;
    }
  }
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
