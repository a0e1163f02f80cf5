#include "rubsweep/ring/track.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ring/random_system.hpp"
#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::ring {
namespace {

Track track_of(const System& system, double top_rpm, int count) {
  return track_modes(system, normal_form(system), batch::evenly_spaced(0.0, top_rpm * rpm, count));
}

/// Frequency of a mode at this speed.
double frequency(const Track& track, const char* name, double speed_rpm) {
  double found = -1;
  for (const TrackPoint& point : track.points) {
    if (std::abs(point.speed_rad_per_s - speed_rpm * rpm) > 1e-9) continue;
    for (std::size_t i = 0; i < point.mode.size(); ++i) {
      if (track.names[static_cast<std::size_t>(point.mode[i])] == name) {
        found = std::max(found, point.spectrum.values(static_cast<Eigen::Index>(i)).imag());
      }
    }
  }
  return found;
}

TEST(TrackModes, NamesTheWavesOfTheFreeRing) {
  System system = spring_masses({60}, 0.1);
  system.loads[0].motion = Motion::tangential;
  const Track track = track_of(system, 800, 801);
  EXPECT_EQ(track.names, (std::vector<std::string>{"ring forward", "ring backward", "load 0 flexural"}));
  for (const double speed : {50.0, 163.0, 165.0, 400.0}) {
    EXPECT_NEAR(frequency(track, "ring forward", speed), 2 * std::abs(17.2 - speed * rpm), 1e-9) << speed;
    EXPECT_NEAR(frequency(track, "ring backward", speed), 2 * (17.2 + speed * rpm), 1e-9) << speed;
    EXPECT_NEAR(frequency(track, "load 0 flexural", speed), std::sqrt(1e4 - 1.01 * speed * speed * rpm * rpm),
                1e-9)
        << speed;
  }
}

TEST(TrackModes, CallsALoadAlongItsInclinationRadial) {
  System system = spring_masses({60, 90, 120});
  system.loads[0].inclination_deg = 60;
  system.loads[1].motion = Motion::radial;
  EXPECT_EQ(track_of(system, 10, 2).names,
            (std::vector<std::string>{"ring forward", "ring backward", "load 0 radial", "load 2 flexural"}));
}

TEST(TrackModes, EveryModeHasTwoRootsAndPairsStayTogether) {
  RandomSystems random(21, 4);
  for (int i = 0; i < 25; ++i) {
    const System system = random.next();
    const auto speeds = batch::evenly_spaced(0.0, 2 * critical_speed(system.ring), 120);
    const Track track = track_modes(system, normal_form(system), speeds);
    std::size_t asked = 0;
    for (const TrackPoint& point : track.points) {
      asked += point.asked ? 1 : 0;
      for (int mode = 0; mode < static_cast<int>(track.names.size()); ++mode) {
        EXPECT_EQ(std::count(point.mode.begin(), point.mode.end(), mode), 2);
      }
      const auto& values = point.spectrum.values;
      for (Eigen::Index k = 0; k + 1 < values.size(); ++k) {
        if (values(k).imag() > 0) {
          EXPECT_EQ(point.mode[static_cast<std::size_t>(k)], point.mode[static_cast<std::size_t>(k) + 1]);
        }
      }
    }
    EXPECT_EQ(asked, speeds.size());
    EXPECT_TRUE(std::is_sorted(track.points.begin(), track.points.end(), [](const auto& a, const auto& b) {
      return a.speed_rad_per_s < b.speed_rad_per_s;
    }));
  }
}

TEST(TrackModes, FollowsTheSameCurvesOnACoarseAndAFineGrid) {
  const System system = spring_masses({60});
  const Track coarse = track_of(system, 440, 45), fine = track_of(system, 440, 4401);
  for (const char* name : {"ring forward", "ring backward", "load 0 flexural"}) {
    for (const double speed : {100.0, 250.0, 400.0}) {
      EXPECT_NEAR(frequency(coarse, name, speed), frequency(fine, name, speed), 1e-9) << name << " " << speed;
    }
  }
}

TEST(TrackModes, TellsForwardFromBackwardWhereBothStartEqual) {
  // Three equal loads at intervals of 60 degrees are isotropic: at rest both ring modes have the same
  // frequency.
  const Track track = track_of(spring_masses({60, 120, 180}), 200, 201);
  EXPECT_GT(frequency(track, "ring backward", 100), frequency(track, "ring forward", 100) + 10);
}

TEST(TrackDescribeMode, SaysWhatACurveLooksLikeAfterAVeering) {
  const System system = spring_masses({60});
  const Track track = track_of(system, 1000, 1001);
  // Speeds below and above the veering near 252 rpm.
  EXPECT_EQ(describe_mode_near(track, 100 * rpm, {0, frequency(track, "ring backward", 100)}),
            "ring backward");
  EXPECT_EQ(describe_mode_near(track, 400 * rpm, {0, frequency(track, "load 0 flexural", 400)}),
            "load 0 flexural (moves as ring backward)");
}

}  // namespace
}  // namespace rubsweep::ring
