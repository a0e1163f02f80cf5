#pragma once

#include <algorithm>
#include <chrono>

namespace rubsweep::batch {

/// Time of one task after the other on each of several threads.
class LapTime {
 public:
  /// Seconds since the calling thread asked this or another of them last, or since this one was made.
  double lap_s() const {
    static thread_local Clock::time_point last{};
    const Clock::time_point begun = std::max(start_, last);
    last = Clock::now();
    return std::chrono::duration<double>(last - begun).count();
  }

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_ = Clock::now();
};

}  // namespace rubsweep::batch
