#include "rubsweep/batch/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
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

/// A pseudo terminal that hands over what is written to it as it is.
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

  /// All that was written so far.
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

/// Output of `steps` steps of a progress of `total` on a terminal.
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

/// Output of `steps` steps of a progress of `total` in a file.
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
  EXPECT_GE(drawn, 3);  // first, last and at least one in 0.4 s
  EXPECT_LE(static_cast<double>(drawn), 2 + elapsed_s / 0.1);
}

TEST(Progress, SaysWhatASlowCellThatIsRunningCosts) {
  Terminal terminal;
  Progress progress(1001, ProgressMode::automatic, terminal.stream());
  progress.advance(1000);
  std::this_thread::sleep_for(std::chrono::milliseconds(1600));
  progress.refresh();
  progress.refresh();  // too soon
  // The average cell would promise the end in no time.
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

}  // namespace
}  // namespace rubsweep::batch
