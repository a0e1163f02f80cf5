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

/// `automatic`: only when the stream is a terminal.
enum class ProgressMode { automatic, always, never };

/// Predicts how long the cells of a map that are left will take. Quiet cells take milliseconds, rubbing ones
/// a hundred times as long, and chaotic ones ten times that, but neighbours on the map are alike: a cell that
/// is left counts as the mean of the finished ones near it, the nearer the more, and as the mean of all only
/// where none is near. Not for use by several threads at once.
class CellsLeft {
 public:
  /// A map of `rows` rows of `columns` cells, numbered along the rows; `cells` are those to be computed.
  CellsLeft(std::size_t columns, std::size_t rows, std::span<const std::size_t> cells);

  /// One of the cells is finished, after `seconds` on one thread; without them where nobody measured.
  void finish(std::size_t cell, std::optional<double> seconds);

  /// Seconds that all cells left take, one after the other; empty before any was measured.
  std::optional<double> one_by_one_s() const;

  std::size_t left() const { return left_; }

  /// Seconds that the finished cells took, one after the other; those that nobody measured count as the
  /// others do.
  double finished_s() const;

 private:
  /// Cells of a small rectangle of the map.
  struct Tile {
    double seconds = 0;
    std::size_t measured = 0, left = 0;
  };

  std::size_t tile_of(std::size_t cell) const;

  /// Sums over all tiles above and to the left of each corner of tiles.
  std::vector<Tile> corner_sums() const;

  std::size_t columns_, left_, finished_ = 0;
  std::size_t side_ = 1;                ///< side of a tile, in cells
  std::size_t width_ = 1, height_ = 1;  ///< size of the map, in tiles
  std::vector<Tile> tiles_;
};

/// "0:07:02", also for days: "50:00:00".
std::string hours_minutes_seconds(double duration_s);

/// "132/1320 cells, 10%, 45.2 cells/s, 0:00:26 left" after `elapsed_s` seconds, which did not go into the
/// first `done_before` cells. The rate and the time left are missing as long as nothing tells them (no cell
/// or no time yet). The percentage is rounded down. Cells are not alike: where the last ones took longer than
/// the average, `recent_s_per_cell`, so may those that are left, and that time is said. Where their
/// neighbours tell how long they take, `left_s`, that is said instead.
std::string progress_line(std::size_t done, std::size_t total, double elapsed_s, std::size_t done_before = 0,
                          double recent_s_per_cell = 0, std::optional<double> left_s = {});

/// Time until the cells that are left are finished, by their neighbours: they keep as many threads busy as
/// those before them did in `elapsed_s` seconds, where there are so many of them. `waited_s` seconds without
/// a finished cell promise as many more. Empty where nothing was measured.
std::optional<double> time_left_s(const CellsLeft& cells, double elapsed_s, double waited_s);

/// How many of `cells` are run first to tell how long all of them take: a few for each thread, and no more
/// than a sixteenth, so that nobody waits long for the answer. 0 where there are too few for that.
std::size_t pilot_count(std::size_t cells, std::size_t threads);

/// "about 0:12:30 by 32 cells spread over the map", when those took `elapsed_s` seconds and `left` remain;
/// empty for a small map, of less than 1000 cells, that takes less than ten seconds.
std::string forecast(std::size_t pilots, double elapsed_s, std::size_t left);

/// A line that counts finished cells: on a terminal rewritten in place at most ten times a second, in a file
/// or a pipe one line after another, every ten seconds. The time left is what the neighbours of the cells
/// left say, where it is known which these are, else what the average cell says, or what as many last cells
/// as are left say, whichever is longer. Time counts from construction; `done_before` cells were finished by
/// then. Not for use by several threads at once.
class Progress {
 public:
  Progress(std::size_t total, ProgressMode mode, std::FILE* stream = stderr, std::size_t done_before = 0);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Tells which cells are to be finished, before any is.
  void expect(CellsLeft cells) { cells_ = std::move(cells); }

  /// Counts so many more finished cells.
  void advance(std::size_t cells = 1);

  /// Counts a finished cell that was expected, and the seconds that it took on its thread, where they are
  /// known.
  void finish_cell(std::size_t cell, std::optional<double> seconds);

  /// Draws the line anew, as time goes by while no cell is finished; on a terminal at most once a second.
  void refresh();

  /// Puts `text` on a line of its own above, where progress is shown; true if it is.
  bool say(const std::string& text);

  /// Replaces the line by "1320/1320 cells in 0:00:29" and ends it; later calls do nothing. The destructor
  /// calls it, so that an error message after an exception starts on its own line.
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
  std::FILE* stream_;  ///< null: nothing is (or is any longer) shown
  bool in_place_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_ = start_;
  std::size_t drawn_width_ = 0;
  std::optional<CellsLeft> cells_{};
  std::deque<Clock::time_point> ends_;  ///< ends of the last cells, as many as are left, within reason
};

/// Time of one task after the other on each of several threads.
class LapTime {
 public:
  /// Seconds since the calling thread asked this or another of them last, or since this one was made.
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
