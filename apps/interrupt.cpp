#include "interrupt.hpp"

#include <csignal>

namespace rubsweep::apps {
namespace {

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
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
  return stop;
}

int caught_signal() { return signal_number; }

}  // namespace rubsweep::apps
