#include "rubsweep/maps/batch/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <regex>
#include <thread>

namespace rubsweep::batch {
namespace {

TEST(ProgressLine, TellsRateAndTimeLeft) {
  EXPECT_EQ(progress_line(132, 1320, 2.92), "132/1320 cells, 10%, 45.2 cells/s, 0:00:26 left");
  EXPECT_EQ(progress_line(1, 3601, 1), "1/3601 cells, 0%, 1.00 cells/s, 1:00:00 left");
  EXPECT_EQ(progress_line(500, 1000000, 1), "500/1000000 cells, 0%, 500 cells/s, 0:33:19 left");
  EXPECT_EQ(progress_line(1, 1001, 40), "1/1001 cells, 0%, 0.025 cells/s, 11:06:40 left");
}

TEST(ProgressForecast, AFewCellsAllOverTheMapTellHowLongTheOthersTake) {
  EXPECT_EQ(pilot_count(31, 2), 0u);
  EXPECT_EQ(pilot_count(160, 2), 10u);
  EXPECT_EQ(pilot_count(100000, 2), 32u);
  EXPECT_EQ(forecast(32, 6.4, 3750), "about 0:12:30 by 32 cells spread over the map");
  EXPECT_EQ(forecast(10, 0.5, 150), "");
  EXPECT_EQ(forecast(10, 0.5, 990), "about 0:00:50 by 10 cells spread over the map");
}

TEST(ProgressLine, GuessesNothingBeforeItCan) {
  EXPECT_EQ(progress_line(0, 10, 0), "0/10 cells, 0%");
  EXPECT_EQ(progress_line(0, 10, 5), "0/10 cells, 0%");
  EXPECT_EQ(progress_line(3, 10, 0), "3/10 cells, 30%");
  EXPECT_EQ(progress_line(0, 0, 0), "0/0 cells, 100%");
}

TEST(ProgressLine, CountsNoTimeForWhatWasDoneBefore) {
  EXPECT_EQ(progress_line(600, 1000, 5, 500), "600/1000 cells, 60%, 20.0 cells/s, 0:00:20 left");
  EXPECT_EQ(progress_line(500, 1000, 5, 500), "500/1000 cells, 50%");
}

TEST(ProgressLine, PromisesNoMoreThanTheLastCellsDo) {
  EXPECT_EQ(progress_line(1316, 1320, 300, 0, 15), "1316/1320 cells, 99%, 4.39 cells/s, 0:01:00 left");
  EXPECT_EQ(progress_line(132, 1320, 2.92, 0, 0.001), "132/1320 cells, 10%, 45.2 cells/s, 0:00:26 left");
}

TEST(ProgressLine, IsFullOnlyAtTheEnd) {
  EXPECT_EQ(progress_line(999, 1000, 999), "999/1000 cells, 99%, 1.00 cells/s, 0:00:01 left");
  EXPECT_EQ(progress_line(1000, 1000, 10), "1000/1000 cells, 100%, 100 cells/s, 0:00:00 left");
}

/// A pseudo terminal that returns what is written to it without changes.
class Terminal {
 public:
  Terminal() : main_end_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(main_end_);
    ::unlockpt(main_end_);
    stream_ = std::fopen(::ptsname(main_end_), "w");
    termios plain{};
    ::tcgetattr(fileno(stream_), &plain);
    ::cfmakeraw(&plain);
    ::tcsetattr(fileno(stream_), TCSANOW, &plain);
  }
  ~Terminal() {
    std::fclose(stream_);
    ::close(main_end_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  std::FILE* stream() const { return stream_; }

  /// All text written so far.
  std::string text() {
    std::fflush(stream_);
    std::string all;
    pollfd waiting{.fd = main_end_, .events = POLLIN, .revents = 0};
    while (::poll(&waiting, 1, 100) > 0 && (waiting.revents & POLLIN) != 0) {
      std::array<char, 4096> piece{};
      const ssize_t length = ::read(main_end_, piece.data(), piece.size());
      if (length <= 0) break;
      all.append(piece.data(), static_cast<std::size_t>(length));
    }
    return all;
  }

 private:
  int main_end_;
  std::FILE* stream_;
};

/// Output on a terminal for `steps` steps of a progress with `total` cells.
std::string written_to_terminal(std::size_t total, std::size_t steps, std::chrono::milliseconds pause) {
  Terminal terminal;
  {
    Progress progress(total, ProgressMode::automatic, terminal.stream());
    for (std::size_t i = 0; i < steps; ++i) {
      std::this_thread::sleep_for(pause);
      progress.advance();
    }
  }
  return terminal.text();
}

/// Output in a file for `steps` steps of a progress with `total` cells.
std::string written_to_file(ProgressMode mode, std::size_t total, std::size_t steps,
                            std::chrono::milliseconds pause = {}) {
  std::FILE* file = std::tmpfile();
  {
    Progress progress(total, mode, file);
    for (std::size_t i = 0; i < steps; ++i) {
      std::this_thread::sleep_for(pause);
      progress.advance();
    }
  }
  std::rewind(file);
  std::array<char, 4096> text{};
  const std::size_t length = std::fread(text.data(), 1, text.size(), file);
  std::fclose(file);
  return std::string(text.data(), length);
}

TEST(Progress, IsSilentUnlessATerminalOrAsked) {
  EXPECT_EQ(written_to_file(ProgressMode::automatic, 10, 10), "");
  EXPECT_EQ(written_to_file(ProgressMode::never, 10, 10), "");
}

TEST(Progress, EndsWithTheTotalTimeAlsoWhenStoppedEarly) {
  EXPECT_EQ(written_to_file(ProgressMode::always, 10, 0), "0/10 cells, 0%\n0/10 cells in 0:00:00\n");
  EXPECT_TRUE(written_to_file(ProgressMode::always, 10, 7).ends_with("\n7/10 cells in 0:00:00\n"));
}

TEST(Progress, RewritesItsLineAtMostTenTimesASecond) {
  const auto start = std::chrono::steady_clock::now();
  const std::string text = written_to_terminal(200, 200, std::chrono::milliseconds(2));
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto drawn = std::ranges::count(text, '\r');
  EXPECT_GE(drawn, 3);  // the first, the last and at least one in 0.4 s
  EXPECT_LE(static_cast<double>(drawn), 2 + elapsed_s / 0.1);
}

TEST(Progress, SaysWhatASlowCellThatIsRunningCosts) {
  Terminal terminal;
  Progress progress(1001, ProgressMode::automatic, terminal.stream());
  progress.advance(1000);
  std::this_thread::sleep_for(std::chrono::milliseconds(1600));
  progress.refresh();
  progress.refresh();  // too early for another line
  // Computed from the average cell, the remaining time would be almost zero.
  const std::string text = terminal.text();
  EXPECT_TRUE(std::regex_match(text, std::regex("\r0/1001 cells, 0%\r1000/1001 cells, 99%, [0-9.]+ cells/s, "
                                                "(0:00:0[1-9]|0:[0-9:]+[1-9][0-9]) left")))
      << text;
  progress.finish();
}

TEST(Progress, IsLinesWhereNothingCanBeRewritten) {
  const std::string text = written_to_file(ProgressMode::always, 200, 200, std::chrono::milliseconds(2));
  EXPECT_EQ(text.find('\r'), std::string::npos) << text;
  EXPECT_TRUE(std::regex_match(text, std::regex("0/200 cells, 0%\n200/200 cells in 0:00:[0-9]{2}\n")))
      << text;
}

TEST(Progress, LeavesNothingOfALongerLine) {
  const std::string text = written_to_terminal(2, 2, std::chrono::milliseconds(110));
  const auto before = text.rfind('\r', text.rfind('\r') - 1);
  const auto longer = text.rfind('\r') - before - 1;
  const auto last = text.size() - text.rfind('\r') - 2;
  EXPECT_TRUE(text.ends_with("\n"));
  EXPECT_GE(last, longer) << text;
}

TEST(Progress, ShowsOnATerminal) {
  const std::string text = written_to_terminal(5, 0, {});
  EXPECT_EQ(text, "\r0/5 cells, 0%\r0/5 cells in 0:00:00\n");
}

std::vector<std::size_t> all_of(std::size_t cells) {
  std::vector<std::size_t> numbers(cells);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

TEST(Progress, KnowsNothingBeforeACellWasMeasured) {
  CellsLeft cells(4, 4, all_of(16));
  EXPECT_EQ(cells.left(), 16u);
  EXPECT_FALSE(cells.one_by_one_s().has_value());
  EXPECT_EQ(cells.finished_s(), 0);
  cells.finish(3, {});
  EXPECT_EQ(cells.left(), 15u);
  EXPECT_FALSE(cells.one_by_one_s().has_value());
}

TEST(Progress, AreAsTheOthersWhereAllAreAlike) {
  CellsLeft cells(5, 3, all_of(15));
  cells.finish(0, 2);
  EXPECT_NEAR(*cells.one_by_one_s(), 28, 1e-12);
  cells.finish(14, 2);
  EXPECT_NEAR(*cells.one_by_one_s(), 26, 1e-12);
  EXPECT_EQ(cells.finished_s(), 4);
  cells.finish(1, {});
  EXPECT_NEAR(*cells.one_by_one_s(), 24, 1e-12);
  EXPECT_EQ(cells.finished_s(), 6);  // the third row counts like the other two
}

TEST(Progress, AreAsTheirNeighbours) {
  // Cells are quick on the left and slow on the right, where all remaining cells are.
  CellsLeft cells(8, 4, all_of(32));
  for (const std::size_t row : {0u, 1u, 2u, 3u})
    for (const std::size_t column : {0u, 1u, 2u, 3u}) cells.finish(8 * row + column, 1);
  cells.finish(8 + 5, 100);
  cells.finish(8 * 2 + 6, 100);
  EXPECT_GT(*cells.one_by_one_s(), 14 * 60);
  EXPECT_LT(*cells.one_by_one_s(), 14 * 100);  // the mean of all cells would give 14 * 12
}

TEST(Progress, LargeMapsAreTiled) {
  CellsLeft cells(1000, 1000, all_of(1000000));
  for (std::size_t cell = 0; cell < 1000000; cell += 97) cells.finish(cell, cell < 500000 ? 1 : 3);
  const double expected = (500000 * 1. + 500000 * 3.) * (1 - 1 / 97.);
  EXPECT_NEAR(*cells.one_by_one_s() / expected, 1, 1e-3);
}

/// Seconds per cell of an artificial map with 40 speeds and 25 unbalances: quiet below, rubbing above, and on
/// top a tongue with slow chaotic cells.
double seconds_of(std::size_t cell) {
  const auto speed = static_cast<double>(cell % 40);
  const std::size_t unbalance = cell / 40;
  const double tongue = std::abs(speed - 25);
  if (unbalance >= 18 && tongue < 6) return 1.5;
  return unbalance >= 12 ? 0.08 + 0.002 * speed : 0.001;
}

/// Order of cells in a sweep of rubsweep on one thread: 32 cells spread over the map, then the others row by
/// row, so that the slow ones come last.
std::vector<std::size_t> order_of_sweep() {
  std::vector<std::size_t> order, others;
  for (std::size_t cell = 0; cell < 1000; ++cell) (cell * 32 % 1000 < 32 ? order : others).push_back(cell);
  order.insert(order.end(), others.begin(), others.end());
  return order;
}

TEST(ProgressTime, IsHonestWhereTheSlowCellsComeLast) {
  const std::vector<std::size_t> order = order_of_sweep();
  const double total_s = std::accumulate(order.begin(), order.end(), 0.,
                                         [](double sum, std::size_t cell) { return sum + seconds_of(cell); });
  CellsLeft cells(40, 25, order);
  double elapsed_s = 0, worst = 1, worst_by_rate = 1, worst_early = 1, last_off_s = 0;
  for (std::size_t done = 1; done < order.size(); ++done) {
    const std::size_t cell = order[done - 1];
    elapsed_s += seconds_of(cell);
    cells.finish(cell, seconds_of(cell));
    const double true_s = total_s - elapsed_s, said_s = *time_left_s(cells, elapsed_s, 0);
    const double off = std::max(said_s / true_s, true_s / said_s);
    const double by_rate_s = static_cast<double>(order.size() - done) * elapsed_s / static_cast<double>(done);
    if (true_s < total_s / 50) {
      last_off_s = std::max(last_off_s, std::abs(said_s - true_s));
    } else if (elapsed_s > total_s / 2) {
      worst = std::max(worst, off);
      worst_by_rate = std::max({worst_by_rate, by_rate_s / true_s, true_s / by_rate_s});
    } else if (done >= 32) {
      worst_early = std::max(worst_early, off);
    }
  }
  EXPECT_LT(worst_early, 1.5);
  EXPECT_LT(worst, 1.2);
  EXPECT_LT(last_off_s, 1);
  EXPECT_GT(worst_by_rate, 3);
}

TEST(ProgressTime, CountsTheThreadsThatWereBusy) {
  CellsLeft cells(10, 10, all_of(100));
  EXPECT_FALSE(time_left_s(cells, 1, 0).has_value());
  for (std::size_t cell = 0; cell < 40; ++cell) cells.finish(cell, 1);
  EXPECT_NEAR(*time_left_s(cells, 10, 0), 15, 1e-9);  // with four threads
  EXPECT_NEAR(*time_left_s(cells, 80, 0), 60, 1e-9);  // never less than one thread
  for (std::size_t cell = 40; cell < 98; ++cell) cells.finish(cell, 1);
  EXPECT_NEAR(*time_left_s(cells, 24.5, 0), 1, 1e-9);  // two cells for four threads
}

TEST(ProgressTime, AWaitPromisesAsLongAWait) {
  CellsLeft cells(10, 1, all_of(10));
  for (std::size_t cell = 0; cell < 9; ++cell) cells.finish(cell, 1);
  EXPECT_NEAR(*time_left_s(cells, 9, 0), 1, 1e-9);
  EXPECT_NEAR(*time_left_s(cells, 59, 50), 50, 1e-9);
  cells.finish(9, 50);
  EXPECT_EQ(time_left_s(cells, 59, 0), 0);
}

using namespace std::chrono_literals;

TEST(ProgressLapTime, CountsFromTheLastTaskOfTheSameThread) {
  const LapTime time;
  std::this_thread::sleep_for(60ms);
  EXPECT_GE(time.lap_s(), 0.06);
  EXPECT_LT(time.lap_s(), 0.06);
  std::this_thread::sleep_for(20ms);
  EXPECT_GE(time.lap_s(), 0.02);
  double of_other_s = 0;
  std::thread([&] { of_other_s = time.lap_s(); }).join();
  EXPECT_GE(of_other_s, 0.08);  // since `time` was made
}

TEST(ProgressLapTime, ForgetsWhatWasBeforeIt) {
  const LapTime first;
  first.lap_s();
  std::this_thread::sleep_for(60ms);
  EXPECT_LT(LapTime().lap_s(), 0.06);
}

}  // namespace
}  // namespace rubsweep::batch
