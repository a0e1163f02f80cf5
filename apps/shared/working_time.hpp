#pragma once

#include <string>
#include <thread>

namespace rubsweep::apps {

/// Shows on a terminal that a program works, and for how long, where the remaining work is unknown. The line
/// on stderr is rewritten every second from two seconds on, and removed by the destructor. Shows nothing
/// where stderr is not a terminal, or where no thread can be started.
class WorkingTime {
 public:
  /// Line such as "PROGRAM: WORK, 0:00:05"; `shown` is false with --quiet.
  WorkingTime(std::string program, std::string work, bool shown);

 private:
  std::jthread thread_;
};

}  // namespace rubsweep::apps
