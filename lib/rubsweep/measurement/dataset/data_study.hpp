#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/measurement/diagnose/candidate.hpp"
#include "rubsweep/measurement/diagnose/drawn_machine.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::dataset {

enum class Format { csv, matlab };
constexpr std::string_view to_string(Format format) { return enumerator_word(format); }

/// How the instrument samples the motions.
struct Measurement {
  int turns = 32;                  ///< turns of the shaft in every recording, rounded down to whole readings
  double sampling_rate_hz = 5000;  ///< > 0
  int probes = 2;                  ///< 2: x and y; 1: x alone
  /// White noise of every reading: its standard deviation divided by the size of the motion.
  diagnose::Spread noise_share{1e-3, 3e-2, true};
  diagnose::OtherLines other_lines{};  ///< run-out and the like: lines at 1X, 2X, 3X
  double gain_error = 0.02;            ///< standard deviation of each probe's gain about 1
};

/// Shares of the machines in the three parts of the set; they add up to 1.
struct Split {
  double training = 0.7, validation = 0.15, test = 0.15;
};

/// Limits of a rub during the recorded turns, above which a machine would not survive.
struct RubBounds {
  /// Largest force / (contact stiffness x smallest clearance).
  double penetration_ratio = diagnose::usual_penetration_ratio;
  double force_ratio = 100;  ///< largest force on a stop / weight of the rotor
};

/// Everything that decides the bytes of a data set; threads, paths and times do not.
struct DataStudy {
  long recordings = 1000;
  int recordings_per_machine = 10;
  std::uint64_t seed = 1;
  std::vector<diagnose::Candidate> candidates{};
  diagnose::FixedNumbers fixed{};
  double other_causes_share = 0;  ///< share of the recordings without a rub that vibrate from another cause
  diagnose::Spread speed_ratio{1.2, 4.5, false};  ///< shaft speed / natural frequency
  RubBounds rub{};
  Measurement measurement{};
  Split split{};
  Format format = Format::csv;
  std::filesystem::path directory{};  ///< directory of the set; does not change the bytes of its files
};

}  // namespace rubsweep::dataset

namespace rubsweep::config::dataset {

/// Reads the study of a data set: recordings, recordings_per_machine, seed, machine, speed_ratio, candidates,
/// measurement, split, format, output. `name` stands for the file in messages. Throws ConfigError with every
/// problem.
rubsweep::dataset::DataStudy read_data_study_text(std::string_view text, const std::string& name);

}  // namespace rubsweep::config::dataset
