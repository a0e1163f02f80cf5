#include "interrupt.hpp"

#include <condition_variable>
#include <csignal>
#include <mutex>
#include <optional>
#include <stop_token>
#include <system_error>
#include <utility>

namespace rubsweep::apps {
namespace {

constexpr std::chrono::milliseconds interval{100};

std::atomic<bool> stop{false};
std::atomic<int> signal_number{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void remember(int number) {
  signal_number = number;
  stop = true;
  // A second signal ends the program at once.
  std::signal(number, SIG_DFL);
}

}  // namespace

const std::atomic<bool>& catch_interrupts() {
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction inherited {};
    if (::sigaction(number, nullptr, &inherited) == 0 && inherited.sa_handler == SIG_IGN) continue;
    std::signal(number, remember);
  }
  return stop;
}

int caught_signal() { return signal_number; }

Watch::Watch(std::function<void()> tick, std::function<void()> leave) {
  const auto watch = [tick = std::move(tick), leave = std::move(leave)](const std::stop_token& ended) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    std::optional<std::chrono::steady_clock::time_point> stopped;
    while (!wake.wait_for(lock, ended, interval, [&] { return ended.stop_requested(); })) {
      const auto now = std::chrono::steady_clock::now();
      if (stop && !stopped) stopped = now;
      if (stopped && now - *stopped >= grace) {
        leave();
      } else {
        tick();
      }
    }
  };
  try {
    thread_ = std::jthread(watch);
  } catch (const std::system_error&) {
    // A sweep without it is better than none.
  }
}

}  // namespace rubsweep::apps
