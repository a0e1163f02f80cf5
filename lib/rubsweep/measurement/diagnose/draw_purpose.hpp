#pragma once

#include <cstdint>

namespace rubsweep::diagnose {

/// Purposes of the random numbers of a diagnosis.
enum DrawPurpose : std::uint64_t {
  of_prior = 100,
  of_proposal,
  of_observation,
  of_tree,
  of_another_cause,
  of_kit,
  of_mean,
  of_half
};

}  // namespace rubsweep::diagnose
