#include "rubsweep/maps/batch/parallel_run.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::batch {
namespace {

const std::atomic<bool> never = false;
const auto ignore = [](std::size_t) {};

/// Work whose duration differs between cells by a factor of 100.
double uneven_work(std::size_t cell) {
  double x = 0.3 + 1e-3 * static_cast<double>(cell);
  for (int i = 0; i < (cell % 10 == 3 ? 20000 : 200); ++i) x = 3.9 * x * (1 - x);
  return x;
}

std::vector<double> results_with(int threads) {
  std::vector<double> results(300, std::nan(""));
  const auto run_cell = [&](std::size_t cell) { results[cell] = uneven_work(cell); };
  EXPECT_EQ(parallel_run(results.size(), threads, run_cell, ignore, never), results.size());
  return results;
}

TEST(ParallelRun, ResultsDoNotDependOnThreads) {
  std::vector<double> expected;
  for (std::size_t cell = 0; cell < 300; ++cell) expected.push_back(uneven_work(cell));
  for (const int threads : {1, 2, 8, 0}) EXPECT_EQ(results_with(threads), expected) << threads << " threads";
}

TEST(ParallelRun, OneThreadIsTheCallers) {
  const auto caller = std::this_thread::get_id();
  parallel_run(
      100, 1, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), caller); }, ignore, never);
}

/// Starts as many cells as threads, each of which waits for all others: passes only if they run at the same
/// time.
void expect_all_at_once(int threads) {
  std::mutex mutex;
  std::condition_variable started;
  int waiting = 0;
  const auto run_cell = [&](std::size_t) {
    std::unique_lock lock(mutex);
    ++waiting;
    started.notify_all();
    EXPECT_TRUE(started.wait_for(lock, std::chrono::seconds(20), [&] { return waiting == threads; }));
  };
  parallel_run(static_cast<std::size_t>(threads), threads, run_cell, ignore, never);
}

TEST(ParallelRun, UsesEveryThreadAskedFor) {
  expect_all_at_once(2);
  expect_all_at_once(8);  // also on fewer processors
}

TEST(ParallelRun, NeverUsesMoreThreadsThanAskedFor) {
  for (const int threads : {1, 2, 3}) {
    std::atomic<int> running = 0, most = 0;
    const auto run_cell = [&](std::size_t) {
      const int now = ++running;
      for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
      }
      std::this_thread::sleep_for(std::chrono::microseconds(300));
      --running;
    };
    parallel_run(100, threads, run_cell, ignore, never);
    EXPECT_LE(most, threads);
  }
}

TEST(ParallelRun, ReportsEachFinishedCellOnceAndOneAtATime) {
  std::atomic<int> inside = 0;
  std::vector<std::size_t> reported;
  std::vector<double> results(200, 0);
  const auto on_finished = [&](std::size_t cell) {
    EXPECT_EQ(++inside, 1);
    std::this_thread::sleep_for(std::chrono::microseconds(50));  // long enough for another call to overlap
    EXPECT_EQ(results[cell], uneven_work(cell));
    reported.push_back(cell);
    --inside;
  };
  parallel_run(
      200, 8, [&](std::size_t cell) { results[cell] = uneven_work(cell); }, on_finished, never);
  std::ranges::sort(reported);
  ASSERT_EQ(reported.size(), 200u);
  for (std::size_t i = 0; i < 200; ++i) EXPECT_EQ(reported[i], i);
}

TEST(ParallelRun, StopLetsRunningCellsFinishAndStartsNoNewOnes) {
  for (const int threads : {1, 2, 8}) {
    std::atomic<bool> stop = false;
    std::atomic<std::size_t> begun = 0, begun_after_stop = 0;
    std::size_t reported = 0;
    const auto run_cell = [&](std::size_t) {
      // A cell may have checked `stop` just before another cell set it: at most one cell per other thread.
      if (stop) ++begun_after_stop;
      if (++begun == 20) stop = true;
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    };
    const std::size_t finished = parallel_run(
        1000, threads, run_cell, [&](std::size_t) { ++reported; }, stop);
    EXPECT_EQ(finished, begun);
    EXPECT_EQ(finished, reported);
    EXPECT_GE(finished, 20u);
    EXPECT_LT(begun_after_stop, static_cast<std::size_t>(threads));
  }
}

TEST(ParallelRun, NothingRunsWhenStoppedBefore) {
  const std::atomic<bool> stop = true;
  EXPECT_EQ(parallel_run(
                10, 2, [](std::size_t) { FAIL(); }, [](std::size_t) { FAIL(); }, stop),
            0u);
}

TEST(ParallelRun, NoCellsIsFine) { EXPECT_EQ(parallel_run(0, 0, ignore, ignore, never), 0u); }

TEST(ParallelRun, OtherCellsRunAndTheFirstFailureByIndexIsThrown) {
  for (const int threads : {1, 2, 8}) {
    std::atomic<int> ran = 0, reported = 0;
    const auto run_cell = [&](std::size_t cell) {
      ++ran;
      if (cell == 17)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));  // thrown last, but reported first
      if (cell % 20 == 17) throw IoError("no file for " + std::to_string(cell));
    };
    const auto message = message_of<IoError>([&] {
      parallel_run(
          100, threads, run_cell, [&](std::size_t) { ++reported; }, never);
    });
    EXPECT_EQ(message, "cell 17: no file for 17 (5 of 100 cells failed)");
    EXPECT_EQ(ran, 100);
    EXPECT_EQ(reported, 95);
  }
}

template <typename Thrown, typename Expected>
void expect_rethrown_as() {
  EXPECT_EQ(message_of<Expected>([] {
              parallel_run(
                  3, 2,
                  [](std::size_t cell) {
                    if (cell == 1) throw Thrown("odd");
                  },
                  ignore, never);
            }),
            "cell 1: odd (1 of 3 cells failed)");
}

TEST(ParallelRun, FailuresKeepTheKindThatDecidesTheExitCode) {
  expect_rethrown_as<ConfigError, ConfigError>();
  expect_rethrown_as<IoError, IoError>();
  expect_rethrown_as<SolverError, SolverError>();
  expect_rethrown_as<std::out_of_range, SolverError>();
}

TEST(ParallelRun, FailureToReportEndsTheRun) {
  std::atomic<int> ran = 0;
  const auto on_finished = [](std::size_t) { throw IoError("disk full"); };
  EXPECT_EQ(message_of<IoError>([&] {
              parallel_run(
                  1000, 2,
                  [&](std::size_t) {
                    ++ran;
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                  },
                  on_finished, never);
            }),
            "disk full");
  EXPECT_LT(ran, 100);
}

TEST(ParallelRun, NegativeThreadsAreAnError) {
  EXPECT_EQ(message_of<ConfigError>([] { parallel_run(1, -1, ignore, ignore, never); }),
            "threads: -1 is out of range, allowed: 0 (all) or a number >= 1");
}

TEST(ParallelRunRequireThreads, TellsWhatTheSystemDoesNotLetUsStart) {
  require_threads(8);
  const pid_t child = ::fork();
  if (child == 0) {
    // Root has no limit; a user without other processes may start as many threads as the limit allows.
    if (::geteuid() == 0 && ::setuid(54321) != 0) ::_exit(2);
    const rlimit few{.rlim_cur = 1, .rlim_max = 1};
    ::setrlimit(RLIMIT_NPROC, &few);
    try {
      require_threads(1);
      require_threads(8);
    } catch (const ConfigError& error) {
      ::_exit(
          std::string_view(error.what()).starts_with("threads: 8 cannot be started, the system stops at 1 (")
              ? 0
              : 3);
    }
    ::_exit(4);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace rubsweep::batch
