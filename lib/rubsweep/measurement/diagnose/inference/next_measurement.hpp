#pragma once

#include <string>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/diagnosis.hpp"

namespace rubsweep::diagnose::inference {

/// A possible further measurement, and its expected information about the cause.
struct NextMeasurement {
  std::string name;
  double information_bits = 0;  ///< expected information about the cause, bits
};

/// Possible further measurements, the most informative first: another speed, a longer recording, a second
/// probe in addition to a single one. Cases that resemble the recording are simulated under the new
/// measurement. A forest is grown on their features, and its trees classify the cases that they did not draw.
/// The information is the entropy of the present probabilities minus the remaining entropy (expected
/// information; Lindley 1956). At another speed the unbalance stays the same and the kick is repeated. Empty
/// where nothing can be learned.
std::vector<NextMeasurement> next_measurements(const DiagnosisProblem& problem, const Diagnosis& diagnosis,
                                               int threads);

}  // namespace rubsweep::diagnose::inference
