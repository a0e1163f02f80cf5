#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rubsweep::batch {

/// Condition for showing progress. `automatic`: only where the stream is a terminal.
enum class ProgressMode { automatic, always, never };

/// Predicts the time for the remaining cells of a map. Quiet cells take milliseconds, rubbing cells a hundred
/// times as long, and chaotic cells ten times as long as rubbing ones; but neighbours on the map take similar
/// times. For a remaining cell the mean time of the finished cells near it is assumed, weighted by closeness,
/// or the mean of all finished cells where none is near. Only one thread at a time may use it.
class CellsLeft {
 public:
  /// Map of `rows` rows of `columns` cells, numbered along the rows. `cells` are the cells to be computed.
  CellsLeft(std::size_t columns, std::size_t rows, std::span<const std::size_t> cells);

  /// Records that a cell is finished, and its `seconds` on one thread, if they were measured.
  void finish(std::size_t cell, std::optional<double> seconds);

  /// Time in s for all remaining cells on one thread; empty before any cell was measured.
  std::optional<double> one_by_one_s() const;

  std::size_t left() const { return left_; }

  /// Time in s that the finished cells took, summed over threads. A cell without a measured time is assumed
  /// to take the mean time of the others.
  double finished_s() const;

 private:
  /// Small rectangle of the map, with sums over its cells.
  struct Tile {
    double seconds = 0;
    std::size_t measured = 0, left = 0;
  };

  std::size_t tile_of(std::size_t cell) const;

  /// Sums over all tiles above and to the left of each corner of a tile.
  std::vector<Tile> corner_sums() const;

  std::size_t columns_, left_, finished_ = 0;
  std::size_t side_ = 1;                ///< side of a tile, in cells
  std::size_t width_ = 1, height_ = 1;  ///< size of the map, in tiles
  std::vector<Tile> tiles_;
};

/// Duration as text, such as "0:07:02" or, for two days, "50:00:00".
std::string hours_minutes_seconds(double duration_s);

/// Progress as text, such as "132/1320 cells, 10%, 45.2 cells/s, 0:00:26 left". `elapsed_s` excludes the time
/// for the first `done_before` cells. Rate and time left are omitted while they are unknown (no cell or no
/// time yet), and the percentage is rounded down. The time left is computed from the average rate, or from
/// `recent_s_per_cell` where the last cells were slower. `left_s`, the prediction from neighbouring cells,
/// replaces both.
std::string progress_line(std::size_t done, std::size_t total, double elapsed_s, std::size_t done_before = 0,
                          double recent_s_per_cell = 0, std::optional<double> left_s = {});

/// Time in s until the remaining cells are finished, predicted from their neighbours. They are assumed to
/// occupy as many threads as the finished cells did in `elapsed_s` s, if there are enough cells. A wait of
/// `waited_s` s without a finished cell is added once more. Empty where nothing was measured.
std::optional<double> time_left_s(const CellsLeft& cells, double elapsed_s, double waited_s);

/// Number of `cells` that are run first to predict the total time: a few for each thread. It is at most a
/// sixteenth of all cells, so that the prediction comes soon, and 0 where there are too few cells.
std::size_t pilot_count(std::size_t cells, std::size_t threads);

/// Prediction such as "about 0:12:30 by 32 cells spread over the map", if these took `elapsed_s` s and `left`
/// cells remain. Empty for a map of less than 1000 cells that takes less than ten seconds.
std::string forecast(std::size_t pilots, double elapsed_s, std::size_t left);

/// Line of text that counts finished cells. On a terminal it is rewritten in place at most ten times a
/// second; in a file or pipe a new line follows every ten seconds. The time left is computed from the
/// neighbours of the remaining cells if these are known. Otherwise it is computed from the average over all
/// cells, or over as many last cells as remain, whichever is longer. Time is measured from construction, when
/// `done_before` cells were finished. Only one thread at a time may use it.
class Progress {
 public:
  Progress(std::size_t total, ProgressMode mode, std::FILE* stream = stderr, std::size_t done_before = 0);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Sets the cells that are to be finished. Call it before any cell is finished.
  void expect(CellsLeft cells) { cells_ = std::move(cells); }

  /// Counts `cells` more finished cells.
  void advance(std::size_t cells = 1);

  /// Counts a finished cell out of the expected ones, and the seconds that it took on its thread, if known.
  void finish_cell(std::size_t cell, std::optional<double> seconds);

  /// Redraws the line while no cell is finished, on a terminal at most once a second.
  void refresh();

  /// Prints `text` on a line of its own above the progress line, if progress is shown; returns whether it is.
  bool say(const std::string& text);

  /// Replaces the line by "1320/1320 cells in 0:00:29" and ends it; later calls do nothing. The destructor
  /// also calls finish, so that an error message after an exception starts on a new line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  double elapsed_s() const;
  double recent_s_per_cell() const;
  std::string line() const;
  void end_line();
  void draw(const std::string& line);

  std::size_t done_before_;
  std::size_t done_ = done_before_;
  std::size_t total_;
  std::FILE* stream_;  ///< null: nothing is shown, or nothing any more
  bool in_place_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_ = start_;
  std::size_t drawn_width_ = 0;
  std::optional<CellsLeft> cells_{};
  /// end times of the last cells; their number is that of the remaining cells, up to a limit
  std::deque<Clock::time_point> ends_;
};

/// Measures the time of consecutive tasks on each of several threads.
class LapTime {
 public:
  /// Seconds since the calling thread last called lap_s of any LapTime, or since this LapTime was
  /// constructed.
  double lap_s() const {
    static thread_local Clock::time_point last{};
    const Clock::time_point begun = std::max(start_, last);
    last = Clock::now();
    return std::chrono::duration<double>(last - begun).count();
  }

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_ = Clock::now();
};

}  // namespace rubsweep::batch
