#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

namespace rubsweep::batch {

/// `automatic`: only when the stream is a terminal.
enum class ProgressMode { automatic, always, never };

/// "132/1320 cells, 10%, 45.2 cells/s, 0:00:26 left" after `elapsed_s` seconds. The rate and the time left
/// are missing as long as nothing tells them (no cell or no time yet). The percentage is rounded down.
std::string progress_line(std::size_t done, std::size_t total, double elapsed_s);

/// A line on a terminal that counts finished cells, rewritten in place at most ten times a second. Time
/// counts from construction. Not for use by several threads at once.
class Progress {
 public:
  Progress(std::size_t total, ProgressMode mode, std::FILE* stream = stderr);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more cell is finished.
  void advance();

  /// Replaces the line by "1320/1320 cells in 0:00:29" and ends it; later calls do nothing. The destructor
  /// calls it, so that an error message after an exception starts on its own line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  double elapsed_s() const;
  void draw(const std::string& line);

  std::size_t done_ = 0;
  std::size_t total_;
  std::FILE* stream_;  ///< null: nothing is (or is any longer) shown
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_ = start_;
  std::size_t drawn_width_ = 0;
};

}  // namespace rubsweep::batch
