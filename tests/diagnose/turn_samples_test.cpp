#include "rubsweep/diagnose/turn_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "rubsweep/diagnose/drawn_machine.hpp"
#include "rubsweep/integrate/start.hpp"
#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::diagnose {
namespace {

TEST(TurnSamples, AreInMetres) {
  Point values{};
  for (double& value : values) value = 1;
  values[static_cast<std::size_t>(Unknown::natural_frequency)] = 30;
  values[static_cast<std::size_t>(Unknown::damping_ratio)] = 0.02;
  const scene::Cell cell =
      scene::build_cell(drawn_machine(Cause::no_rub, values, 1e-4, {}), 60, scene::Eccentricity{1e-5});
  integrate::exact::modes::ModeCache modes;
  const auto run = integrate::start(cell.scene, {}, modes);
  integrate::run::TurnReport turn;
  integrate::run::TurnRequest request;
  request.samples_per_revolution = 16;
  std::vector<std::complex<double>> samples;
  for (int k = 0; k < 2; ++k) {
    ASSERT_EQ(run.advance(request, turn), integrate::run::Outcome::ok);
    add_samples(cell.scene, turn, samples);
  }
  ASSERT_EQ(samples.size(), 32U);
  const double amplitude = 1e-5 * 4 / std::hypot(1 - 4, 2 * 0.02 * 2);
  for (const auto& z : samples) EXPECT_NEAR(std::abs(z), amplitude, 1e-9 * amplitude);
}

}  // namespace
}  // namespace rubsweep::diagnose
