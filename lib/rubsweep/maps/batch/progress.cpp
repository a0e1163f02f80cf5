#include "rubsweep/maps/batch/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace rubsweep::batch {
namespace {

/// Largest number of tiles: few enough to sum over all of them ten times a second.
constexpr std::size_t most_tiles = 4096;

/// Number of measured cells at which a neighbourhood has as much weight as the wider neighbourhood around it.
constexpr double weight_of_wider = 0.5;

constexpr std::size_t tiles_along(std::size_t cells, std::size_t side) { return (cells - 1) / side + 1; }

constexpr auto redraw_interval = std::chrono::milliseconds(100),
               refresh_interval = std::chrono::milliseconds(1000),
               line_interval = std::chrono::milliseconds(10000);

constexpr std::size_t most_ends = 1024;

/// Rate with three significant figures and no exponent.
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

CellsLeft::CellsLeft(std::size_t columns, std::size_t rows, std::span<const std::size_t> cells)
    : columns_(columns), left_(cells.size()) {
  while (tiles_along(columns, side_) * tiles_along(rows, side_) > most_tiles) ++side_;
  width_ = tiles_along(columns, side_);
  height_ = tiles_along(rows, side_);
  tiles_.resize(width_ * height_);
  for (const std::size_t cell : cells) ++tiles_[tile_of(cell)].left;
}

std::size_t CellsLeft::tile_of(std::size_t cell) const {
  return cell / columns_ / side_ * width_ + cell % columns_ / side_;
}

void CellsLeft::finish(std::size_t cell, std::optional<double> seconds) {
  Tile& tile = tiles_[tile_of(cell)];
  --left_;
  ++finished_;
  --tile.left;
  if (!seconds) return;
  tile.seconds += *seconds;
  ++tile.measured;
}

std::vector<CellsLeft::Tile> CellsLeft::corner_sums() const {
  const std::size_t corners = width_ + 1;
  std::vector<Tile> sums(corners * (height_ + 1));
  for (std::size_t y = 0; y < height_; ++y) {
    Tile row;
    for (std::size_t x = 0; x < width_; ++x) {
      const Tile &tile = tiles_[y * width_ + x], &above = sums[y * corners + x + 1];
      row.seconds += tile.seconds;
      row.measured += tile.measured;
      sums[(y + 1) * corners + x + 1] = {above.seconds + row.seconds, above.measured + row.measured, 0};
    }
  }
  return sums;
}

double CellsLeft::finished_s() const {
  const Tile all = corner_sums().back();
  return all.measured == 0 ? 0
                           : all.seconds * static_cast<double>(finished_) / static_cast<double>(all.measured);
}

std::optional<double> CellsLeft::one_by_one_s() const {
  const std::vector<Tile> sums = corner_sums();
  const Tile& all = sums.back();
  if (all.measured == 0) return std::nullopt;
  const std::size_t corners = width_ + 1;
  std::size_t widest = 1;
  while (2 * widest < std::max(width_, height_)) widest *= 2;
  double seconds = 0;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    if (tiles_[i].left == 0) continue;
    const std::size_t x = i % width_, y = i / width_;
    double mean = all.seconds / static_cast<double>(all.measured);
    for (std::size_t reach = widest; reach > 0; reach /= 2) {
      const std::size_t left = x - std::min(x, reach), right = std::min(x + reach + 1, width_),
                        above = (y - std::min(y, reach)) * corners,
                        below = std::min(y + reach + 1, height_) * corners;
      const double near_s = sums[below + right].seconds - sums[above + right].seconds -
                            sums[below + left].seconds + sums[above + left].seconds;
      const std::size_t near = sums[below + right].measured - sums[above + right].measured -
                               sums[below + left].measured + sums[above + left].measured;
      mean = (near_s + weight_of_wider * mean) / (static_cast<double>(near) + weight_of_wider);
    }
    seconds += static_cast<double>(tiles_[i].left) * mean;
  }
  return seconds;
}

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

std::size_t pilot_count(std::size_t cells, std::size_t threads) {
  constexpr std::size_t most_for_a_thread = 16, part = 16;
  if (cells < part * threads) return 0;
  return std::min(most_for_a_thread * threads, cells / part);
}

std::string forecast(std::size_t pilots, double elapsed_s, std::size_t left) {
  constexpr double least_s = 10;
  constexpr std::size_t small = 1000;
  const double left_s = elapsed_s / static_cast<double>(pilots) * static_cast<double>(left);
  if (left_s < least_s && pilots + left < small) return "";
  return fmt::format("about {} by {} cells spread over the map", hours_minutes_seconds(left_s), pilots);
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

/// Time per cell in s, averaged over the recorded end times and the time since the last of them. Slow cells
/// that still run therefore count at once.
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
  // Blanks overwrite the rest of a longer line. The result is ignored, as a closed terminal must not end the
  // run.
  std::fputs(fmt::format("\r{:<{}}", line, drawn_width_).c_str(), stream_);
  std::fflush(stream_);
  drawn_width_ = line.size();
}

}  // namespace rubsweep::batch
