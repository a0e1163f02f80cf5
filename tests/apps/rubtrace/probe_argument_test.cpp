#include "rubtrace/probe_argument.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/error.hpp"
#include "shared/program.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::apps {
namespace {

TEST(ProbeArgument, SaysPlaceQuantityDirectionAndNoise) {
  const ProbeArgument casing = probe_of("stop0:acceleration:90:0.5"), shaft = probe_of("shaft:velocity:-30"),
                      gap = probe_of("shaft-stop12:displacement:45");
  EXPECT_FALSE(casing.on_shaft);
  EXPECT_EQ(casing.stop, 0U);
  EXPECT_EQ(casing.derivative, 2);
  EXPECT_EQ(casing.angle_deg, 90);
  EXPECT_EQ(casing.noise, 0.5);
  EXPECT_TRUE(shaft.on_shaft);
  EXPECT_FALSE(shaft.stop);
  EXPECT_EQ(shaft.derivative, 1);
  EXPECT_EQ(shaft.angle_deg, -30);
  EXPECT_TRUE(gap.on_shaft);
  EXPECT_EQ(gap.stop, 12U);
}

TEST(ProbeArgument, RefusesWhatIsNotUnderstood) {
  for (const char* text : {"", "shaft", "shaft:speed:0", "stop:velocity:0", "stop0:velocity",
                           "casing:velocity:0", "stop-1:velocity:0", "shaft:velocity:x", "shaft:velocity:inf",
                           "shaft:velocity:0:-1", "shaft:velocity:0:1:2", "shaft:velocity:0:"})
    EXPECT_THROW(probe_of(text), UsageError) << text;
}

TEST(ProbeArgument, ReadsShaftCasingAndTheirDistance) {
  const auto prepared = scene::prepare_machine(test::machine_of(test::OneSideRotor{}));
  const trace::Probes probes =
      probes_of({probe_of("shaft:displacement:0:1e-6"), probe_of("stop0:velocity:90:2e-3"),
                 probe_of("shaft-stop0:displacement:90")},
                prepared, 1e-3, {"catcher"});
  Eigen::MatrixXd rows(3, 4);
  rows << 1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, -1;
  EXPECT_LT((probes.rows - rows).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(probes.derivative, (std::vector<int>{0, 1, 0}));
  EXPECT_EQ(probes.noise, (std::vector<double>{1e-6, 2e-3, 0}));
  EXPECT_EQ(probes.noise_m(), 1e-6);
  EXPECT_EQ(probes.name, (std::vector<std::string>{"", "catcher", "catcher"}));
}

TEST(ProbeArgument, RefusesStopsThatTheMachineHasNot) {
  model::Machine machine = test::machine_of(test::OneSideRotor{});
  EXPECT_THROW(probes_of({probe_of("stop1:velocity:0")}, scene::prepare_machine(machine), 1e-3), ConfigError);
  machine.stops[0].casing.reset();
  const auto rigid = scene::prepare_machine(machine);
  EXPECT_THROW(probes_of({probe_of("stop0:velocity:0")}, rigid, 1e-3), ConfigError);
  EXPECT_NO_THROW(probes_of({probe_of("shaft-stop0:displacement:0")}, rigid, 1e-3));
}

TEST(ProbeArgument, OnlyDisplacementsOfOnePlaceArePairs) {
  const std::vector<double> places = places_of(
      {probe_of("shaft:displacement:0"), probe_of("shaft:displacement:90"),
       probe_of("shaft-stop0:displacement:90"), probe_of("shaft:velocity:0"), probe_of("shaft:velocity:90")});
  EXPECT_EQ(places[0], places[1]);
  EXPECT_NE(places[0], places[2]);
  EXPECT_TRUE(std::isnan(places[3]) && std::isnan(places[4]));
}

}  // namespace
}  // namespace rubsweep::apps
