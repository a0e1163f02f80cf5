#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "exit_code.hpp"
#include "forecast.hpp"
#include "interrupt.hpp"
#include "map_directory.hpp"
#include "mpi_messages.hpp"
#include "program.hpp"
#include "rubsweep/batch/chunk_queue.hpp"
#include "rubsweep/batch/line_log.hpp"
#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/batch/progress.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/report/describe_footprint.hpp"
#include "rubsweep/report/describe_refinement.hpp"
#include "rubsweep/report/map_csv.hpp"
#include "rubsweep/sweep/footprint.hpp"
#include "rubsweep/sweep/run_cells.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view program_name = "rubsweep-mpi";

std::string help() {
  return "mpirun -n N rubsweep-mpi CONFIG.yaml [--output DIR] [--threads N] [--set KEY.PATH=VALUE]... "
         "[--fresh]\n"
         "                         [--progress auto|always|never] [--quiet]\n"
         "Computes one map with N processes that share the output directory; see rubsweep --help for the "
         "options.\n"
         "--threads counts for each process. The map is the same, byte for byte, as that of rubsweep, and so "
         "is what\n"
         "happens when a run ends early: the same command, with any number of processes, computes the "
         "rest.\n";
}

/// What the first rank found out before there is anything to share.
struct Job {
  RubsweepArguments arguments;
  config::RunConfig config;
  std::optional<MapDirectory> directory;
};

/// Returns an exit code; there is a job when it is `done`, and the map is not only asked about and not there.
/// Each rank may take `memory_bytes`.
ExitCode prepare(int argc, char** argv, int ranks, std::size_t memory_bytes, std::optional<Job>& job) {
  RubsweepArguments arguments = parse_rubsweep_arguments(argc, argv);
  if (answered(program_name, arguments.action, help)) return done;
  if (arguments.action != Action::run || arguments.shard || arguments.merge || arguments.figure) {
    throw UsageError("this program only computes maps; use rubsweep for everything else");
  }
  config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  report::refuse_refinement(config.study.grid, "a map of several processes");
  report::refuse_more_memory_than(memory_bytes, config.study,
                                  {batch::thread_count(arguments.threads), ranks});
  config.output_directory = fs::absolute(arguments.output.value_or(config.output_directory));
  job.emplace();
  job->arguments = std::move(arguments);
  job->config = std::move(config);
  job->directory.emplace(job->config.output_directory, job->config, std::nullopt, job->arguments.fresh,
                         std::string(program_name));
  if (const auto& map = job->directory->finished_map()) {
    const bool failed_cells = map->summary.has_failed_cells();
    if (!job->arguments.quiet) {
      say(map_is_there(program_name));
      fmt::print("{}map: {}\n", map->summary.text(), job->directory->map().string());
      warn(program_name, map->summary);
    }
    job.reset();
    return failed_cells ? some_cells_failed : done;
  }
  return done;
}

std::string interrupted(const MapDirectory& directory, std::size_t finished) {
  return fmt::format("{}: interrupted; {} of {} cells are finished, the same command computes the others\n",
                     program_name, directory.finished() + finished, directory.cells());
}

/// The first rank: deals out chunks to all ranks, itself included, and shows what is finished.
class Leader {
 public:
  Leader(Job& job, int ranks)
      : job_(job),
        chunks_(job.directory->missing(), static_cast<std::size_t>(ranks)),
        partial_(job.directory->partial()),
        progress_(job.directory->cells(),
                  job.arguments.quiet ? batch::ProgressMode::never : job.arguments.progress, stderr,
                  job.directory->finished()) {
    const int threads = batch::thread_count(job.arguments.threads);
    const std::size_t cells = job.directory->missing().size();
    // The first ones, which come from all over the map, tell how long it will take, where somebody reads it.
    if (progress_.say(report::describe_footprint(job.config.study, {threads, ranks})) &&
        cells >= least_cells_to_forecast)
      pilots_ = std::min(pilots_per_thread * static_cast<std::size_t>(threads * ranks), cells / 4);
  }

  /// Returns how many cells were finished.
  std::size_t run(int workers, const std::atomic<bool>& stop) {
    std::exception_ptr failure;
    std::atomic<bool> own_done = false;
    std::jthread own([&] {
      try {
        compute();
      } catch (...) {
        failure = std::current_exception();
      }
      own_done = true;
    });
    try {
      while (workers > 0 || !own_done) {
        if (serve()) --workers;
        if (own_done && failure) break;
        if (stop) end(caught_signal());
        if (ended_ && ChunkClock::now() - *ended_ >= grace) leave();
        const std::lock_guard lock(mutex_);
        progress_.refresh();
      }
    } catch (...) {
      chunks_.close();  // or the destructor would wait for all of them
      throw;
    }
    own.join();
    if (failure) std::rethrow_exception(failure);
    progress_.finish();
    return finished_;
  }

  /// That ended the work of any rank; 0: none did.
  int signal() const { return signal_; }

 private:
  using ChunkClock = batch::ChunkQueue::Clock;

  /// A signal to one rank ends the work of all.
  void end(int signal) {
    if (ended_) return;
    ended_ = ChunkClock::now();
    signal_ = signal;
    ending_ = true;
    chunks_.close();
  }

  /// Cells that still run are given up, here and in the other ranks.
  [[noreturn]] void leave() {
    const std::lock_guard lock(mutex_);
    progress_.finish();
    say(interrupted(*job_.directory, finished_));
    job_.directory->leave();
    mpi::abort(128 + signal_);
  }

  /// Answers one report, if there is one; true when that worker is done.
  bool serve() {
    const auto report = mpi::receive_report(std::chrono::milliseconds(1));
    if (!report) return false;
    {
      const std::lock_guard lock(mutex_);
      keep(report->lines);
    }
    if (report->signal != 0) end(report->signal);
    if (report->signal != 0) return true;
    const batch::Chunk chunk = chunks_.next(static_cast<std::size_t>(report->rank));
    mpi::send_chunk(report->rank, chunk);
    return chunk.empty();
  }

  void compute() {
    batch::Journal journal = job_.directory->journal();
    for (batch::Chunk chunk = chunks_.next(0); !chunk.empty(); chunk = chunks_.next(0)) {
      sweep::run_cells(
          job_.config.study, chunk, job_.arguments.threads,
          [&](std::size_t cell, const sweep::Row& row) {
            const std::string line = report::map_line(row, job_.config.study);
            const std::lock_guard lock(mutex_);
            journal.append(cell, line);
            keep(line + '\n');
          },
          ending_);
    }
  }

  /// With the mutex held.
  void keep(std::string_view lines) {
    if (lines.empty()) return;
    const auto count = static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n'));
    partial_.append(lines.substr(0, lines.size() - 1));
    finished_ += count;
    progress_.advance(count);
    if (pilots_ == 0 || finished_ < pilots_) return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    progress_.say(forecast(finished_, elapsed.count(), job_.directory->missing().size() - finished_));
    pilots_ = 0;
  }

  Job& job_;
  batch::ChunkQueue chunks_;
  std::optional<ChunkClock::time_point> ended_;  ///< when the first signal was heard of
  int signal_ = 0;
  std::atomic<bool> ending_ = false;  ///< no new cell starts
  std::mutex mutex_;                  ///< guards the journal and what follows
  batch::LineLog partial_;
  batch::Progress progress_;
  std::size_t finished_ = 0;
  std::size_t pilots_ = 0;  ///< finished cells that a forecast wants; 0: none, or no longer
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

ExitCode work(const config::RunConfig& config, int rank, int threads) {
  const std::atomic<bool>& stop = catch_interrupts();
  std::optional<batch::Journal> journal;
  std::string lines;
  std::mutex mutex;  // guards the journal
  // A rank in the middle of a long cell cannot report any more. One that ends like this ends the job, and the
  // others are told by a signal.
  std::optional<Watch> watch(
      std::in_place, [] {},
      [&] {
        const std::lock_guard lock(mutex);
        std::_Exit(128 + caught_signal());
      });
  while (true) {
    const int signal = caught_signal();  // once: what is reported is what is done
    mpi::send_report({rank, signal, std::move(lines)});
    lines.clear();
    if (signal != 0) break;
    const batch::Chunk chunk = mpi::receive_chunk();
    if (chunk.empty()) break;
    if (!journal) journal.emplace(rank_journal(config, rank));
    sweep::run_cells(
        config.study, chunk, threads,
        [&](std::size_t cell, const sweep::Row& row) {
          const std::string line = report::map_line(row, config.study);
          const std::lock_guard lock(mutex);
          journal->append(cell, line);
          lines.append(line).append("\n");
        },
        stop);
  }
  watch.reset();
  journal.reset();
  mpi::wait_for_all();
  return done;
}

int lead(Job& job, int ranks) {
  const std::atomic<bool>& stop = catch_interrupts();
  const MapDirectory& directory = *job.directory;
  const bool quiet = job.arguments.quiet;
  if (!quiet && directory.finished() > 0) {
    say(fmt::format("{}: {} of {} cells were finished before\n", program_name, directory.finished(),
                    directory.cells()));
  }
  Leader leader(job, ranks);
  const std::size_t finished = leader.run(ranks - 1, stop);
  mpi::wait_for_all();
  if (finished < directory.missing().size()) {
    say(interrupted(directory, finished));
    return 128 + leader.signal();
  }
  const report::MapSummary summary = directory.write_map();
  if (!quiet) {
    fmt::print("{}map: {}\n", summary.text(), directory.map().string());
    warn(program_name, summary);
  }
  return summary.has_failed_cells() ? some_cells_failed : done;
}

int run(int argc, char** argv) {
  const int rank = mpi::rank(), ranks = mpi::ranks();
  const std::size_t memory_bytes =
      mpi::smallest(machine_memory_bytes() / static_cast<std::size_t>(mpi::ranks_on_this_machine()));
  std::optional<Job> job;
  int code = 0;
  if (rank == 0) {
    code = run_program(program_name, [&] { return prepare(argc, argv, ranks, memory_bytes, job); });
  }
  code = mpi::broadcast_number(code);
  const int threads = mpi::broadcast_number(job ? job->arguments.threads : 0);
  const std::string text = mpi::broadcast_text(job ? config::print_config(job->config) : "");
  if (code != done || text.empty()) return code;
  code = run_program(program_name, [&] {
    batch::require_threads(threads, 1);
    if (job) return lead(*job, ranks);
    return static_cast<int>(work(config::read_run_config_text(text, "the first rank", {}), rank, threads));
  });
  // The others would wait for ever for a rank that gave up; all journals are as the system has them.
  if (code != done && code != some_cells_failed && code < 128) mpi::abort(code);
  return code;
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  rubsweep::apps::open_standard_descriptors();
  const rubsweep::apps::mpi::Session session(argc, argv);
  return rubsweep::apps::run(argc, argv);
}
