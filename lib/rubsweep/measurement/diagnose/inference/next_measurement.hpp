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

/// Possible further measurements, the most informative first: another speed, a longer record, a second probe
/// where there was one. Cases that resemble the recording are simulated under the new measurement, and a
/// forest grown on their features classifies those that its trees did not draw. The result is the entropy of
/// the probabilities now minus the remaining one (expected information; Lindley 1956). At another speed the
/// unbalance stays the same and the kick happens again. Empty where nothing can be learned.
std::vector<NextMeasurement> next_measurements(const DiagnosisProblem& problem, const Diagnosis& diagnosis,
                                               int threads);

}  // namespace rubsweep::diagnose::inference
