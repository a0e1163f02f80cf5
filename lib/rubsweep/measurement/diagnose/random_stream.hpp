#pragma once

#include <cstdint>

namespace rubsweep::diagnose {

/// Purposes that keep the random streams of a diagnosis apart.
enum DrawPurpose : std::uint64_t {
  of_prior = 100,
  of_observation = 102,  // 101 was that of motions near the likeliest ones
  of_tree,
  of_another_cause,
  of_kit,
  of_mean,
  of_half,
  of_further_speed
};

/// Random numbers that depend on three numbers alone: a seed, the index of the drawn object, and the purpose,
/// which separates streams of the same index. So any thread can make any stream. The generator is SplitMix64
/// (Steele, Lea, Flood 2014), started from a mixture of the three numbers.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t index, std::uint64_t purpose);

  std::uint64_t bits();
  double uniform();  ///< uniform in [0, 1), a multiple of 2^-53
  double normal();   ///< normal with mean 0 and standard deviation 1 (Box and Muller 1958)

 private:
  std::uint64_t state_;
  double waiting_ = 0;
  bool has_waiting_ = false;
};

/// Prior distribution of a number between two bounds: uniform, or uniform in its logarithm, but with a
/// probability of its own for the lower bound. Equal bounds: the number is known.
struct Spread {
  double low = 0, high = 0;  ///< low <= high; both > 0 where logarithmic
  bool logarithmic = false;
  double at_low = 0;  ///< probability of `low`, below 1
};

/// Quantile: the number lies below this value with probability `unit`, in [0, 1].
double value_at(const Spread& spread, double unit);

}  // namespace rubsweep::diagnose
