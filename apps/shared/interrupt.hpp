#pragma once

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace rubsweep::apps {

/// Makes SIGINT and SIGTERM end the program at once with exit code 128 + signal, after the message "PROGRAM:
/// interrupted; WORDS", or "PROGRAM: interrupted" without words, on stderr. Empty directories made for
/// results are removed. `words` must be a string literal.
void end_on_interrupts(const char* words);

/// Delays these signals during its lifetime, so that a set of files is written whole and temporary files are
/// removed. Only for programs with one thread.
class InterruptsWait {
 public:
  InterruptsWait();
  ~InterruptsWait();
  InterruptsWait(const InterruptsWait&) = delete;
  InterruptsWait& operator=(const InterruptsWait&) = delete;

 private:
  sigset_t before_;
};

/// Makes SIGINT and SIGTERM only set the returned flag, so that running cells can finish and their results
/// are kept. A signal ignored at the program's start (nohup and the like) stays ignored.
const std::atomic<bool>& catch_interrupts();

/// The signal that set the flag; 0 if none did.
int caught_signal();

/// Time that running cells get after a signal. They are not awaited longer, because a cell may need minutes.
constexpr std::chrono::milliseconds grace{500};

/// Calls `tick` about ten times a second during its lifetime; once the grace time after a signal has passed,
/// it calls `leave` instead. Both are called on a separate thread. If the system cannot start one, neither is
/// called, and a signal takes effect when the running cells end.
class Watch {
 public:
  Watch(std::function<void()> tick, std::function<void()> leave);

 private:
  std::jthread thread_;
};

}  // namespace rubsweep::apps
