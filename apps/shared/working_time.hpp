#pragma once

#include <string>
#include <thread>

namespace rubsweep::apps {

/// Says on a terminal that a program is at work, and for how long, for work of which nobody knows how much is left:
/// a line on stderr that is rewritten once a second, from two seconds on, and goes with this. Nothing is shown where
/// stderr is no terminal, or the system allows no thread.
class WorkingTime {
 public:
  /// "PROGRAM: WORK, 0:00:05"; `shown` is false with --quiet.
  WorkingTime(std::string program, std::string work, bool shown);

 private:
  std::jthread thread_;
};

}  // namespace rubsweep::apps
