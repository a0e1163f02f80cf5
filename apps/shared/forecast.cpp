#include "shared/forecast.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "rubsweep/maps/batch/progress.hpp"

namespace rubsweep::apps {

std::size_t machine_memory_bytes() {
  return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::size_t pilot_count(std::size_t cells, std::size_t threads) {
  constexpr std::size_t most_for_a_thread = 16, part = 16;
  if (cells < part * threads) return 0;
  return std::min(most_for_a_thread * threads, cells / part);
}

std::string forecast(std::size_t pilots, double elapsed_s, std::size_t left) {
  constexpr double least_s = 10;
  constexpr std::size_t small = 1000;
  const double left_s = elapsed_s / static_cast<double>(pilots) * static_cast<double>(left);
  if (left_s < least_s && pilots + left < small) return "";
  return fmt::format("about {} by {} cells spread over the map", batch::hours_minutes_seconds(left_s),
                     pilots);
}

}  // namespace rubsweep::apps
