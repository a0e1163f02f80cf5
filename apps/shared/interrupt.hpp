#pragma once

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace rubsweep::apps {

/// Makes SIGINT and SIGTERM end the program at once with 128 + signal, after "PROGRAM: interrupted; WORDS" on
/// stderr, or "PROGRAM: interrupted" without words; empty directories that were made for results are removed.
/// `words` is a literal.
void end_on_interrupts(const char* words);

/// While it lives, these signals wait: a set of files is written whole, and temporaries are removed. For
/// programs of one thread.
class InterruptsWait {
 public:
  InterruptsWait();
  ~InterruptsWait();
  InterruptsWait(const InterruptsWait&) = delete;
  InterruptsWait& operator=(const InterruptsWait&) = delete;

 private:
  sigset_t before_;
};

/// Makes SIGINT and SIGTERM only set the returned flag, so that running cells can finish and be kept. A
/// signal that was ignored when the program started (nohup and its like) stays ignored.
const std::atomic<bool>& catch_interrupts();

/// The signal that set the flag, 0 if none did.
int caught_signal();

/// Running cells may take minutes; after a signal they get this long.
constexpr std::chrono::milliseconds grace{500};

/// While it lives, calls `tick` about ten times a second, and `leave` instead once the grace after a signal
/// is over. Both are called on a thread of its own; where the system allows none they are not, and a signal
/// waits for the running cells.
class Watch {
 public:
  Watch(std::function<void()> tick, std::function<void()> leave);

 private:
  std::jthread thread_;
};

}  // namespace rubsweep::apps
