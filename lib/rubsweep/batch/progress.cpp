#include "rubsweep/batch/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace rubsweep::batch {
namespace {

constexpr auto redraw_interval = std::chrono::milliseconds(100),
               refresh_interval = std::chrono::milliseconds(1000),
               line_interval = std::chrono::milliseconds(10000);

constexpr std::size_t most_ends = 1024;

/// Three figures without an exponent.
std::string rate_text(double per_second) {
  const int decimals = per_second >= 100 ? 0 : per_second >= 10 ? 1 : per_second >= 1 ? 2 : 3;
  return fmt::format("{:.{}f}", per_second, decimals);
}

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) != 0; }

bool shows(ProgressMode mode, std::FILE* stream) {
  if (mode == ProgressMode::automatic) return is_terminal(stream);
  return mode == ProgressMode::always;
}

}  // namespace

std::string hours_minutes_seconds(double duration_s) {
  const auto seconds = std::llround(duration_s);
  return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

std::string progress_line(std::size_t done, std::size_t total, double elapsed_s, std::size_t done_before,
                          double recent_s_per_cell, std::optional<double> left_s) {
  const std::size_t percent = total == 0 ? 100 : 100 * done / total;
  std::string line = fmt::format("{}/{} cells, {}%", done, total, percent);
  if (done == done_before || elapsed_s <= 0) return line;
  const double rate = static_cast<double>(done - done_before) / elapsed_s;
  if (!left_s) left_s = static_cast<double>(total - done) * std::max(1 / rate, recent_s_per_cell);
  return line + fmt::format(", {} cells/s, {} left", rate_text(rate), hours_minutes_seconds(*left_s));
}

std::optional<double> time_left_s(const CellsLeft& cells, double elapsed_s, double waited_s) {
  const std::optional<double> one_by_one_s = cells.one_by_one_s();
  if (!one_by_one_s || elapsed_s <= 0) return std::nullopt;
  if (cells.left() == 0) return 0;
  const double busy = std::max(1.0, cells.finished_s() / elapsed_s);
  return std::max(*one_by_one_s / std::min(busy, static_cast<double>(cells.left())), waited_s);
}

Progress::Progress(std::size_t total, ProgressMode mode, std::FILE* stream, std::size_t done_before)
    : done_before_(done_before),
      total_(total),
      stream_(shows(mode, stream) ? stream : nullptr),
      in_place_(is_terminal(stream)) {
  if (stream_) draw(progress_line(done_, total_, 0, done_before_));
}

void Progress::advance(std::size_t cells) {
  done_ += cells;
  if (!stream_) return;
  const Clock::time_point now = Clock::now();
  const std::size_t worth_keeping = std::min(most_ends, total_ - std::min(done_, total_));
  ends_.insert(ends_.end(), std::min(cells, most_ends), now);
  while (ends_.size() > worth_keeping) ends_.pop_front();
  if (now - drawn_ < (in_place_ ? redraw_interval : line_interval)) return;
  draw(line());
  drawn_ = now;
}

void Progress::finish_cell(std::size_t cell, std::optional<double> seconds) {
  if (cells_) cells_->finish(cell, seconds);
  advance();
}

void Progress::refresh() {
  if (!stream_ || Clock::now() - drawn_ < (in_place_ ? refresh_interval : line_interval)) return;
  draw(line());
  drawn_ = Clock::now();
}

bool Progress::say(const std::string& text) {
  if (!stream_) return false;
  draw(text);
  if (!in_place_) return true;
  end_line();
  draw(line());
  return true;
}

void Progress::finish() {
  if (!stream_) return;
  draw(fmt::format("{}/{} cells in {}", done_, total_, hours_minutes_seconds(elapsed_s())));
  if (in_place_) end_line();
  std::fflush(stream_);
  stream_ = nullptr;
}

double Progress::elapsed_s() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

/// Time per cell since the first of the kept ends, with the wait since the last: slow cells that are running
/// count as soon as they are slow.
double Progress::recent_s_per_cell() const {
  if (ends_.empty()) return 0;
  return std::chrono::duration<double>(Clock::now() - ends_.front()).count() /
         static_cast<double>(ends_.size());
}

std::string Progress::line() const {
  const double elapsed = elapsed_s();
  std::optional<double> left_s;
  if (cells_ && !ends_.empty()) {
    const double waited_s = std::chrono::duration<double>(Clock::now() - ends_.back()).count();
    left_s = time_left_s(*cells_, elapsed, waited_s);
  }
  return progress_line(done_, total_, elapsed, done_before_, recent_s_per_cell(), left_s);
}

void Progress::end_line() {
  std::fputc('\n', stream_);
  drawn_width_ = 0;
}

void Progress::draw(const std::string& line) {
  if (!in_place_) {
    std::fputs((line + '\n').c_str(), stream_);
    std::fflush(stream_);
    return;
  }
  // Blanks cover what a longer line left behind. A terminal that is gone must not end the run.
  std::fputs(fmt::format("\r{:<{}}", line, drawn_width_).c_str(), stream_);
  std::fflush(stream_);
  drawn_width_ = line.size();
}

}  // namespace rubsweep::batch
