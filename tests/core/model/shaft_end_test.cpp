#include "rubsweep/core/model/shaft_end.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::model {
namespace {

/// A kit of segments with a bearing at each end; the position of the second one is given separately.
Machine kit_of_segments(const std::vector<double>& length_m, double end_m) {
  RotorKit kit;
  for (const double length : length_m)
    kit.shaft.push_back({{.outer_diameter_m = 0.01,
                          .youngs_modulus_pa = 2.1e11,
                          .shear_modulus_pa = 8.1e10,
                          .density_kg_per_m3 = 7800},
                         length});
  kit.discs = {
      {.position_m = end_m / 2, .mass_kg = 1, .polar_inertia_kg_m2 = 1e-3, .diametral_inertia_kg_m2 = 6e-4}};
  for (const double place : {0.0, end_m}) {
    Support& support = kit.supports.emplace_back();
    support.position_m = place;
    support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = 1e6;
  }
  Machine machine;
  machine.rotor = kit;
  Stop& stop = machine.stops.emplace_back();
  stop.geometry = OneSideGeometry{90};
  stop.position_m = end_m;
  stop.clearance_m = 1e-3, stop.stiffness_n_per_m = 1e6, stop.contact_radius_m = 0.005;
  stop.damping = ExplicitDamping{10};
  return machine;
}

TEST(ShaftEnd, ABearingThereIsAllowedHoweverTheSegmentsRound) {
  struct Shaft {
    std::vector<double> length_m;
    double end_m;
  };
  for (const auto& [length_m, end_m] :
       {Shaft{{0.7, 0.1}, 0.8}, Shaft{{0.229, 0.131, 0.104}, 0.464}, Shaft{{0.1, 0.7, 0.1}, 0.9}}) {
    // The sum of the lengths is one unit in the last place below the given end.
    const double sum = std::accumulate(length_m.begin(), length_m.end(), 0.0);
    EXPECT_EQ(std::nextafter(sum, 1), end_m);
    EXPECT_NO_THROW(validate(kit_of_segments(length_m, end_m))) << end_m;
  }
}

TEST(ShaftEnd, OneBeyondIsRefused) {
  const std::string message = message_of<ConfigError>([] {
    validate(kit_of_segments({0.7, 0.1}, 0.8 + 1e-6));
  });
  EXPECT_NE(message.find("supports.1.position_m"), std::string::npos) << message;
}

}  // namespace
}  // namespace rubsweep::model
