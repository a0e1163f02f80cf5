#include "rubscope/followed_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "rubsweep/core/error.hpp"

namespace rubsweep::apps {
namespace {

using std::numbers::pi;

constexpr double sampling_hz = 2000, sweep_s = 20;

/// Speed of a sweep from 12 to 58 Hz or back at an instant, uneven by `bend`, and its turns since the start.
struct SweptShaft {
  double from_hz = 12, to_hz = 58, bend = 0;

  double speed_hz(double t) const {
    const double share = t / sweep_s;
    return from_hz + (to_hz - from_hz) * (share + bend * share * (1 - share));
  }
  double turns(double t) const {
    const double share = t / sweep_s;
    return from_hz * t + (to_hz - from_hz) * sweep_s *
                             (share * share / 2 + bend * (share * share / 2 - share * share * share / 3));
  }
};

/// Readings of the quasi-steady response of a mode at 33 Hz with 5 % of damping to unbalance, with a line of
/// order 2, mains hum at 50 Hz, and noise.
std::vector<double> readings_of(const SweptShaft& shaft, double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, noise);
  std::vector<double> readings;
  for (int k = 0; k < static_cast<int>(sampling_hz * sweep_s); ++k) {
    const double t = k / sampling_hz, ratio = shaft.speed_hz(t) / 33, angle = 2 * pi * shaft.turns(t);
    const std::complex<double> response =
        ratio * ratio / std::complex<double>(1 - ratio * ratio, 0.1 * ratio);
    readings.push_back(10 * (response * std::polar(1.0, angle)).real() + 4 * std::cos(2 * angle + 1) +
                       2 * std::cos(2 * pi * 50 * t) + normal(random) + 300);
  }
  return readings;
}

TEST(FollowedLine, HasTheSpeedOfTheShaftAlongASweep) {
  for (const SweptShaft& shaft : {SweptShaft{}, SweptShaft{58, 12}, SweptShaft{12, 58, 0.5}}) {
    for (const unsigned seed : {1U, 2U}) {
      // A description knows the ends to a tenth.
      const auto found = follow_line({readings_of(shaft, 2, seed)}, 5, sampling_hz,
                                     {1.1 * shaft.from_hz, 0.9 * shaft.to_hz});
      ASSERT_TRUE(found);
      // A half turn is that of the phase across the resonance.
      EXPECT_NEAR(static_cast<double>(found->begin_s.size()), shaft.turns(sweep_s), 2);
      int off = 0;
      for (std::size_t k = 20; k + 20 < found->begin_s.size(); ++k) {
        const double speed_hz = 4 / (found->begin_s[k + 2] - found->begin_s[k - 2]);
        off += std::abs(speed_hz - shaft.speed_hz(found->begin_s[k] - 5)) > 0.01 * speed_hz + 0.2;
      }
      EXPECT_LE(off, static_cast<int>(found->begin_s.size()) / 50) << shaft.from_hz << ' ' << shaft.bend;
      EXPECT_LT(found->speed_uncertainty_hz, 0.2);
      EXPECT_GT(found->speed_uncertainty_hz, 1e-4);
    }
  }
}

TEST(FollowedLine, IsNoneInNoise) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal(0, 1);
  std::vector<double> noise(40000);
  for (double& value : noise) value = normal(random);
  EXPECT_FALSE(follow_line({noise}, 0, sampling_hz, {12, 58}));
  EXPECT_FALSE(follow_line({std::vector<double>(40000, 3.0)}, 0, sampling_hz, {12, 58}));
  EXPECT_FALSE(follow_line({std::vector<double>(100, 3.0)}, 0, sampling_hz, {12, 58}));
}

TEST(FollowedLine, GivesARecordingItsTurns) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, 1);
  recording::Channels channels;
  channels.channels = {{"x", "um", {}}};
  for (int k = 0; k < 40000; ++k) {
    const double t = k / 2000.0, turns = (12 + 1.15 * t) * t;
    channels.channels[0].values.push_back(20 * std::cos(2 * pi * turns) + 5 * std::cos(6 * pi * turns) +
                                          noise(random));
  }
  recording::Instrument instrument{
      .sampling_rate_hz = 2000, .probes = {{"x", 0}}, .sweep = recording::Sweep{12, 58}};
  const auto recorded = [&] {
    const recording::FollowedTurns turns = followed_turns(channels, instrument, "f.csv");
    return make_recording(channels, instrument, "f.csv", &turns);
  };
  const recording::Recording recording = recorded();
  EXPECT_NEAR(recording.turns(), 12 * 20 + 1.15 * 400, 2);
  EXPECT_FALSE(recording.phased);
  ASSERT_FALSE(recording.findings.empty());
  EXPECT_TRUE(recording.findings[0].starts_with("the speed is that of the line followed through the sweep"));
  for (std::size_t turn = 10; turn + 10 < recording.turn_begin_s.size(); ++turn) {
    const double middle_s = (recording.turn_begin_s[turn] + recording.turn_begin_s[turn + 1]) / 2;
    EXPECT_NEAR(1 / (recording.turn_begin_s[turn + 1] - recording.turn_begin_s[turn]), 12 + 2.3 * middle_s,
                0.4);
  }
  instrument.from_s = 10;
  instrument.sweep = recording::Sweep{35, 58};
  const recording::Recording second_half = recorded();
  EXPECT_GE(second_half.turn_begin_s.front(), 10);
  EXPECT_NEAR(1 / (second_half.turn_begin_s[1] - second_half.turn_begin_s[0]), 35, 1);
  instrument.sweep = recording::Sweep{200, 300};
  try {
    recorded();
    ADD_FAILURE();
  } catch (const ConfigError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("f.csv: sweep: no line stands out from 200 to 300 Hz"));
  }
}

}  // namespace
}  // namespace rubsweep::apps
