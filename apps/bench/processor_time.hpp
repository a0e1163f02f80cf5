#pragma once

#include <ctime>

namespace rubsweep::bench {

/// Processor time of the calling thread in seconds, from an arbitrary zero. Time used by other programs does
/// not count.
inline double processor_time_s() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace rubsweep::bench
