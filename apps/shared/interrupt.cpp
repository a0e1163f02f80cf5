#include "shared/interrupt.hpp"

#include <unistd.h>

#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string_view>
#include <system_error>
#include <utility>

#include "shared/open_line.hpp"
#include "shared/result_directory.hpp"

namespace rubsweep::apps {
namespace {

constexpr std::chrono::milliseconds wake_interval{100};

std::atomic<bool> stop{false};
std::atomic<int> signal_number{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void remember(int number) {
  signal_number = number;
  stop = true;
  // A second signal ends the program at once.
  std::signal(number, SIG_DFL);
}

std::atomic<const char*> words_at_the_end{""};
static_assert(std::atomic<const char*>::is_always_lock_free);

void write_out(std::string_view text) { (void)!::write(STDERR_FILENO, text.data(), text.size()); }

void end_now(int number) {
  const std::string_view words = words_at_the_end.load();
  if (line_is_open()) write_out("\n");
  write_out(program_invocation_short_name);
  write_out(words.empty() ? ": interrupted" : ": interrupted; ");
  write_out(words);
  write_out("\n");
  remove_empty_result_directories();
  ::_exit(128 + number);
}

void handle(void (*handler)(int)) {
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction inherited {};
    if (::sigaction(number, nullptr, &inherited) == 0 && inherited.sa_handler == SIG_IGN) continue;
    std::signal(number, handler);
  }
}

}  // namespace

void end_on_interrupts(const char* words) {
  words_at_the_end = words;
  handle(end_now);
}

InterruptsWait::InterruptsWait() : before_{} {
  sigset_t held;
  ::sigemptyset(&held);
  ::sigaddset(&held, SIGINT);
  ::sigaddset(&held, SIGTERM);
  ::pthread_sigmask(SIG_BLOCK, &held, &before_);
}

InterruptsWait::~InterruptsWait() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

const std::atomic<bool>& catch_interrupts() {
  handle(remember);
  return stop;
}

int caught_signal() { return signal_number; }

Watch::Watch(std::function<void()> tick, std::function<void()> leave) {
  const auto watch = [tick = std::move(tick), leave = std::move(leave)](const std::stop_token& ended) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    std::optional<std::chrono::steady_clock::time_point> stopped;
    while (!wake.wait_for(lock, ended, wake_interval, [&] { return ended.stop_requested(); })) {
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
    // A sweep without progress display is better than no sweep.
  }
}

}  // namespace rubsweep::apps
