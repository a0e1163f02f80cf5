#include "shared/working_time.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <utility>

#include "rubsweep/maps/batch/progress.hpp"
#include "shared/interrupt.hpp"
#include "shared/open_line.hpp"

namespace rubsweep::apps {
namespace {

constexpr std::chrono::seconds first_shown{2}, shown_interval{1};

void put(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

void show(const std::stop_token& ended, const std::string& what) {
  std::mutex mutex;
  std::condition_variable_any wake;
  std::unique_lock lock(mutex);
  const auto begun = std::chrono::steady_clock::now();
  std::size_t width = 0;
  auto wait = first_shown;
  while (!wake.wait_for(lock, ended, wait, [&] { return ended.stop_requested(); })) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begun;
    const std::string line = fmt::format("{}, {}", what, batch::hours_minutes_seconds(elapsed.count()));
    set_open_line(true);
    put("\r" + line);
    width = line.size();
    wait = shown_interval;
  }
  if (width > 0) put(fmt::format("\r{:{}}\r", "", width));
  set_open_line(false);
}

}  // namespace

WorkingTime::WorkingTime(std::string program, std::string work, bool shown) {
  if (!shown || ::isatty(STDERR_FILENO) == 0) return;
  // Signals must go to the working thread, which may block them while files are written.
  const InterruptsWait not_here;
  try {
    thread_ = std::jthread([what = std::move(program) + ": " +
                                   std::move(work)](const std::stop_token& ended) { show(ended, what); });
  } catch (const std::system_error&) {
    // Work without a display is better than no work.
  }
}

}  // namespace rubsweep::apps
