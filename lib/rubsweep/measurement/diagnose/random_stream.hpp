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

/// Random numbers that depend on three numbers alone, so that any thread may make any stream: a seed, the
/// index of what is drawn, and its purpose, which keeps draws of one index apart. SplitMix64 (Steele, Lea,
/// Flood 2014) from a start that these numbers are mixed into.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t index, std::uint64_t purpose);

  std::uint64_t bits();
  double uniform();  ///< in [0, 1), multiples of 2^-53
  double normal();   ///< mean 0, standard deviation 1 (Box and Muller 1958)

 private:
  std::uint64_t state_;
  double waiting_ = 0;
  bool has_waiting_ = false;
};

/// Knowledge of a number before a recording is looked at: it lies between two bounds, every part of the
/// interval being as likely, or every part of its logarithm. Equal bounds: it is known.
struct Spread {
  double low = 0, high = 0;  ///< low <= high; both > 0 where logarithmic
  bool logarithmic = false;
};

/// Value below which the number lies with probability `unit`, in [0, 1].
double value_at(const Spread& spread, double unit);

}  // namespace rubsweep::diagnose
