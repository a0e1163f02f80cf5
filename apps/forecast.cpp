#include "forecast.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "rubsweep/batch/progress.hpp"

namespace rubsweep::apps {

std::size_t machine_memory_bytes() {
  return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::string forecast(std::size_t pilots, double elapsed_s, std::size_t left) {
  const double cell_s = elapsed_s / static_cast<double>(pilots);
  return fmt::format("about {} by {} cells spread over the map",
                     batch::hours_minutes_seconds(cell_s * static_cast<double>(left)), pilots);
}

}  // namespace rubsweep::apps
