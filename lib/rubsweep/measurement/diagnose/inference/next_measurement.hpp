#pragma once

#include <string>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/diagnosis.hpp"

namespace rubsweep::diagnose::inference {

/// Another measurement, and how much it would tell of the candidates.
struct NextMeasurement {
  std::string name;
  double information_bits = 0;  ///< expected, on average over what the candidates let expect
};

/// Measurements that could follow, the most telling first: another speed, a longer record, a second probe
/// where there was one. Cases that resemble the recording are run again under them; a forest that is grown on
/// what they would show is asked about those that it did not draw: the entropy of the probabilities now less
/// that which it leaves (expected information; Lindley 1956). At another speed the unbalance stays and the
/// kick comes again. Empty where nothing is left to be told.
std::vector<NextMeasurement> next_measurements(const DiagnosisProblem& problem, const Diagnosis& diagnosis,
                                               int threads);

}  // namespace rubsweep::diagnose::inference
