#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
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

/// Returns an exit code; there is a job when it is `done` and the map is not only asked about. Each rank may
/// take `memory_bytes`.
ExitCode prepare(int argc, char** argv, int ranks, std::size_t memory_bytes, std::optional<Job>& job) {
  RubsweepArguments arguments = parse_rubsweep_arguments(argc, argv);
  if (answered(program_name, arguments.action, help)) return done;
  if (arguments.action != Action::run || arguments.shard || arguments.merge) {
    throw UsageError("this program only computes maps; use rubsweep for everything else");
  }
  config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  sweep::refuse_more_memory_than(memory_bytes, config.study, {batch::thread_count(arguments.threads), ranks});
  config.output_directory = fs::absolute(arguments.output.value_or(config.output_directory));
  job.emplace();
  job->arguments = std::move(arguments);
  job->config = std::move(config);
  job->directory.emplace(job->config.output_directory, job->config, std::nullopt, job->arguments.fresh,
                         std::string(program_name));
  return done;
}

/// The first rank: deals out chunks to all ranks, itself included, and shows what is finished.
class Leader {
 public:
  Leader(const Job& job, int ranks)
      : job_(job),
        chunks_(job.directory->missing(), static_cast<std::size_t>(ranks)),
        partial_(job.directory->partial()),
        progress_(job.directory->cells(),
                  job.arguments.quiet ? batch::ProgressMode::never : job.arguments.progress, stderr,
                  job.directory->finished()) {
    const int threads = batch::thread_count(job.arguments.threads);
    const std::size_t cells = job.directory->missing().size();
    // The first ones, which come from all over the map, tell how long it will take, where somebody reads it.
    if (progress_.say(sweep::describe(job.config.study, {threads, ranks})) &&
        cells >= least_cells_to_forecast)
      pilots_ = std::min(pilots_per_thread * static_cast<std::size_t>(threads * ranks), cells / 4);
  }

  /// Returns how many cells were finished.
  std::size_t run(int workers, const std::atomic<bool>& stop) {
    std::exception_ptr failure;
    std::atomic<bool> own_done = false;
    std::jthread own([&] {
      try {
        compute(stop);
      } catch (...) {
        failure = std::current_exception();
      }
      own_done = true;
    });
    try {
      while (workers > 0 || !own_done) {
        if (serve(stop)) --workers;
        if (own_done && failure) break;
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

 private:
  /// Answers one report, if there is one; true when that worker is done.
  bool serve(const std::atomic<bool>& stop) {
    const auto report = mpi::receive_report(std::chrono::milliseconds(1));
    if (!report) return false;
    keep(report->lines);
    if (report->stopped) return true;
    const batch::Chunk chunk = stop ? batch::Chunk{} : chunks_.next(static_cast<std::size_t>(report->rank));
    mpi::send_chunk(report->rank, chunk);
    return chunk.empty();
  }

  void compute(const std::atomic<bool>& stop) {
    batch::Journal journal = job_.directory->journal();
    for (batch::Chunk chunk = chunks_.next(0); !chunk.empty() && !stop; chunk = chunks_.next(0)) {
      sweep::run_cells(
          job_.config.study, chunk, job_.arguments.threads,
          [&](std::size_t cell, const sweep::Row& row) {
            const std::string line = report::map_line(row);
            journal.append(cell, line);
            keep(line + '\n');
          },
          stop);
    }
  }

  void keep(std::string_view lines) {
    if (lines.empty()) return;
    const auto count = static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n'));
    const std::lock_guard lock(mutex_);
    partial_.append(lines.substr(0, lines.size() - 1));
    finished_ += count;
    progress_.advance(count);
    if (pilots_ == 0 || finished_ < pilots_) return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    progress_.say(forecast(finished_, elapsed.count(), job_.directory->missing().size() - finished_));
    pilots_ = 0;
  }

  const Job& job_;
  batch::ChunkQueue chunks_;
  std::mutex mutex_;  ///< guards what follows
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
  while (true) {
    mpi::send_report({rank, stop, std::move(lines)});
    lines.clear();
    if (stop) break;
    const batch::Chunk chunk = mpi::receive_chunk();
    if (chunk.empty()) break;
    if (!journal) journal.emplace(rank_journal(config, rank));
    sweep::run_cells(
        config.study, chunk, threads,
        [&](std::size_t cell, const sweep::Row& row) {
          const std::string line = report::map_line(row);
          journal->append(cell, line);
          lines.append(line).append("\n");
        },
        stop);
  }
  journal.reset();
  mpi::wait_for_all();
  return done;
}

int lead(const Job& job, int ranks) {
  const std::atomic<bool>& stop = catch_interrupts();
  const MapDirectory& directory = *job.directory;
  const bool quiet = job.arguments.quiet;
  if (!quiet && directory.finished() > 0) {
    fmt::print(stderr, "{}: {} of {} cells were finished before\n", program_name, directory.finished(),
               directory.cells());
  }
  const std::size_t finished = Leader(job, ranks).run(ranks - 1, stop);
  mpi::wait_for_all();
  if (finished < directory.missing().size()) {
    fmt::print(stderr, "{}: interrupted; {} of {} cells are finished, the same command computes the others\n",
               program_name, directory.finished() + finished, directory.cells());
    return caught_signal() != 0 ? 128 + caught_signal() : input_output;
  }
  const report::MapSummary summary = directory.write_map();
  if (!quiet) fmt::print("{}map: {}\n", summary.text(), directory.map().string());
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
  const rubsweep::apps::mpi::Session session(argc, argv);
  return rubsweep::apps::run(argc, argv);
}
