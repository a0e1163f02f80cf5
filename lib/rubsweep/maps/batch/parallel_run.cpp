#include "rubsweep/maps/batch/parallel_run.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <future>
#include <new>
#include <numbers>
#include <numeric>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::batch {
namespace {

/// Number of cells that threw, and the exception of the cell with the lowest index.
struct Failures {
  std::size_t count = 0;
  std::size_t first_cell = 0;
  std::exception_ptr first;

  void add(std::size_t cell, std::exception_ptr error) {
    if (count++ == 0 || cell < first_cell) {
      first_cell = cell;
      first = std::move(error);
    }
  }
};

[[noreturn]] void rethrow(const Failures& failures, std::size_t cells) {
  const auto message = [&](const std::exception& error) {
    return fmt::format("cell {}: {} ({} of {} cells failed)", failures.first_cell, error.what(),
                       failures.count, cells);
  };
  try {
    std::rethrow_exception(failures.first);
  } catch (const ConfigError& error) {
    throw ConfigError(message(error));
  } catch (const IoError& error) {
    throw IoError(message(error));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw SolverError(message(error));
  }
}

/// Atomics that repeat happens-before relations of TBB for the thread sanitizer, because libtbb is built
/// without it. Code before the run happens before every cell, and every cell before the code after the run.
/// Two cells are not ordered, so that the sanitizer still finds a race between them.
std::atomic<std::size_t> runs_begun{0}, cells_ended{0};

/// Marks the end of a cell, and of a run, also after an exception.
struct CellEnd {
  ~CellEnd() { cells_ended.fetch_add(1, std::memory_order_release); }
};
struct RunEnd {
  ~RunEnd() { static_cast<void>(cells_ended.load(std::memory_order_acquire)); }
};

/// Body of the loop, which TBB copies from thread to thread. The function has a name, so that
/// tests/thread_sanitizer.supp can refer to it.
struct RunCells {
  const std::function<void(std::size_t)>& run_one;

  void operator()(const tbb::blocked_range<std::size_t>& cells) const { run_cells_of_range(cells); }

  void run_cells_of_range(const tbb::blocked_range<std::size_t>& cells) const {
    static_cast<void>(runs_begun.load(std::memory_order_acquire));
    const CellEnd cell_end;
    for (std::size_t cell = cells.begin(); cell != cells.end(); ++cell) run_one(cell);
  }
};

/// Largest growth of a chunk from one to the next, because a few easy cells do not mean that the next ones
/// are easy.
constexpr double fastest_growth = 4;

/// Divisor of the smallest chunk. Near the end, still smaller chunks would cost more than idle workers.
constexpr std::size_t least_share = 16;

/// Stride near the golden section of `count`, without a common divisor with `count`. Any number of its first
/// multiples is spread as evenly as possible.
std::size_t spreading_stride(std::size_t count) {
  auto stride = static_cast<std::size_t>(static_cast<double>(count) / std::numbers::phi);
  while (std::gcd(stride, count) > 1) ++stride;
  return std::max<std::size_t>(stride, 1);
}

}  // namespace

int thread_count(int threads) {
  if (threads < 0) {
    throw ConfigError(fmt::format("threads: {} is out of range, allowed: 0 (all) or a number >= 1", threads));
  }
  return threads == 0 ? tbb::info::default_concurrency() : threads;
}

std::size_t machine_memory_bytes() {
  return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void require_threads(int threads, int beside) {
  const int count = thread_count(threads);
  if (count == 1) return;
  // The calling thread is one of the threads.
  const auto wanted = static_cast<std::size_t>(count) - 1 + static_cast<std::size_t>(beside);
  // Declared before the promise and joined after it: if anything is thrown, the promise's destructor releases
  // the threads.
  std::vector<std::jthread> started;
  std::promise<void> all_started;
  const std::shared_future<void> end = all_started.get_future().share();
  std::string reason;
  try {
    while (started.size() < wanted) started.emplace_back([end] { end.wait(); });
  } catch (const std::system_error& error) {
    reason = error.code().message();
  }
  all_started.set_value();
  if (reason.empty()) return;
  throw ConfigError(fmt::format("threads: {} cannot be started, the system stops at {} ({}), allowed: fewer",
                                count, started.size() + 1, reason));
}

std::size_t parallel_run(std::size_t count, int threads,
                         const std::function<void(std::size_t cell)>& run_cell,
                         const std::function<void(std::size_t cell)>& on_finished,
                         const std::atomic<bool>& stop) {
  const int concurrency = thread_count(threads);
  std::mutex one_at_a_time;  // guards the variables below and every call of on_finished
  std::size_t finished = 0;
  Failures failures;

  const std::function<void(std::size_t)> run_one = [&](std::size_t cell) {
    if (stop) return;
    try {
      run_cell(cell);
    } catch (...) {
      const std::lock_guard lock(one_at_a_time);
      failures.add(cell, std::current_exception());
      return;
    }
    const std::lock_guard lock(one_at_a_time);
    ++finished;
    on_finished(cell);
  };

  // Both are needed: an arena alone has at most one thread per processor, and with the control alone the
  // caller's arena sets the number.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(concurrency));
  tbb::task_arena arena(concurrency);
  runs_begun.fetch_add(1, std::memory_order_release);
  {
    const RunEnd run_end;
    arena.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), RunCells{run_one},
                        tbb::simple_partitioner());
    });
  }
  if (failures.count > 0) rethrow(failures, count);
  return finished;
}

ChunkQueue::ChunkQueue(std::vector<std::size_t> cells, std::size_t workers)
    : cells_(std::move(cells)), stride_(spreading_stride(cells_.size())), last_(workers) {}

Chunk ChunkQueue::next(std::size_t worker, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  if (dealt_ == cells_.size()) return {};
  Last& last = last_.at(worker);
  std::size_t size = first_chunk;
  if (last.cells > 0) {
    const std::chrono::duration<double> taken = now - last.begun;
    const double growth = taken * fastest_growth > chunk_time ? chunk_time / taken : fastest_growth;
    size = std::clamp<std::size_t>(static_cast<std::size_t>(static_cast<double>(last.cells) * growth), 1,
                                   largest_chunk);
  }
  const std::size_t left = cells_.size() - dealt_;
  size = std::min({size, std::max<std::size_t>({left / (4 * last_.size()), size / least_share, 1}), left});
  Chunk chunk;
  chunk.reserve(size);
  for (; chunk.size() < size; ++dealt_) chunk.push_back(cells_[dealt_ * stride_ % cells_.size()]);
  last = {size, now};
  return chunk;
}

void ChunkQueue::refill(std::vector<std::size_t> cells) {
  const std::lock_guard lock(mutex_);
  cells_ = std::move(cells);
  stride_ = spreading_stride(cells_.size());
  dealt_ = 0;
}

void ChunkQueue::close() {
  const std::lock_guard lock(mutex_);
  dealt_ = cells_.size();
}

}  // namespace rubsweep::batch
