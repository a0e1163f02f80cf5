#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
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
#include "map_outcome.hpp"
#include "mpi_messages.hpp"
#include "program.hpp"
#include "refined_cells.hpp"
#include "rubsweep/batch/chunk_queue.hpp"
#include "rubsweep/batch/line_log.hpp"
#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/batch/progress.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/report/describe_footprint.hpp"
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
         "                         [--figure FILE [--fade]] [--report] [--progress auto|always|never] "
         "[--quiet]\n"
         "Computes one map with N processes that share the output directory; see rubsweep --help for the "
         "options.\n"
         "--threads counts for each process. The map is the same, byte for byte, as that of rubsweep, and so "
         "is what\n"
         "happens when a run ends early: the same command, with any number of processes, computes the "
         "rest. The\n"
         "first process draws the picture and writes report.html, on --threads threads.\n";
}

/// What the first rank found out before there is anything to share.
struct Job {
  RubsweepArguments arguments;
  config::RunConfig config;
  std::optional<MapDirectory> directory;
};

/// Returns an exit code; there is a job when it is `done`, and the map is not only asked about and not there.
/// Each rank may take `memory_bytes`.
int prepare(int argc, char** argv, int ranks, std::size_t memory_bytes, std::optional<Job>& job) {
  RubsweepArguments arguments = parse_rubsweep_arguments(argc, argv);
  if (answered(program_name, arguments.action, help)) return done;
  if (arguments.action != Action::run || arguments.shard || arguments.merge) {
    throw UsageError("this program only computes maps; use rubsweep for everything else");
  }
  config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  refuse_fading(arguments, config.study);
  report::refuse_more_memory_than(memory_bytes, config.study,
                                  {batch::thread_count(arguments.threads), ranks});
  config.output_directory = fs::absolute(arguments.output.value_or(config.output_directory));
  job.emplace();
  job->arguments = std::move(arguments);
  job->config = std::move(config);
  job->directory.emplace(job->config.output_directory, job->config, std::nullopt, job->arguments.fresh,
                         std::string(program_name));
  if (const auto& map = job->directory->finished_map()) {
    if (!job->arguments.quiet) say(map_is_there(program_name));
    const int code =
        report_map(program_name, job->arguments, map->summary, job->config.study, *job->directory);
    job.reset();
    return code;
  }
  return done;
}

std::string interrupted(const MapDirectory& directory, std::size_t finished) {
  return fmt::format("{}: interrupted; {} of {} cells are finished, the same command computes the others\n",
                     program_name, directory.finished() + finished, directory.cells());
}

/// The first rank: deals out chunks to all ranks, itself included, and shows what is finished. A refined map
/// is computed in rounds: what it wants next is known when all that was dealt out is finished.
class Leader {
 public:
  Leader(Job& job, int ranks)
      : job_(job),
        chunks_(job.directory->missing(), static_cast<std::size_t>(ranks)),
        complete_(!job.config.study.grid.refinement),
        partial_(job.directory->partial()),
        progress_(job.directory->cells(),
                  job.arguments.quiet ? batch::ProgressMode::never : job.arguments.progress, stderr,
                  job.directory->finished()) {
    const int threads = batch::thread_count(job.arguments.threads);
    if (!complete_) {
      refined_.emplace(job.config.study.grid);
      refined_->read(*job.directory);
      chunks_.refill(refined_->wanted());
      progress_.say(report::describe_footprint(job.config.study, {threads, ranks}));
      return;
    }
    const std::size_t cells = job.directory->missing().size();
    // The first ones, which come from all over the map, tell how long it will take, where somebody reads it.
    if (progress_.say(report::describe_footprint(job.config.study, {threads, ranks})) &&
        cells >= least_cells_to_forecast)
      pilots_ = std::min(pilots_per_thread * static_cast<std::size_t>(threads * ranks), cells / 4);
  }

  /// Returns how many cells were finished, of all or before a signal.
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
        workers -= begin_round(workers);
        if (ended_ && ChunkClock::now() - *ended_ >= grace) leave();
        const std::lock_guard lock(mutex_);
        progress_.refresh();
      }
    } catch (...) {
      give_up();  // or the destructor would wait for all cells
      throw;
    }
    own.join();
    if (failure) std::rethrow_exception(failure);
    progress_.finish();
    return finished_;
  }

  /// That ended the work of any rank; 0: none did.
  int signal() const { return signal_; }

  /// What a refined map cost; empty of any other.
  std::string description() const { return refined_ ? refined_->description() : ""; }

 private:
  using ChunkClock = batch::ChunkQueue::Clock;

  /// A signal to one rank ends the work of all.
  void end(int signal) {
    if (ended_) return;
    ended_ = ChunkClock::now();
    signal_ = signal;
    ending_ = true;
    give_up();
  }

  /// No cell is dealt out any more, and nobody waits for another round.
  void give_up() {
    const std::lock_guard lock(mutex_);
    complete_ = true;
    chunks_.close();
    next_round_.notify_all();
  }

  /// Deals out the next round of a refined map once all ranks wait for it, and tells them when there is none.
  /// Returns how many of the `workers` are done.
  int begin_round(int workers) {
    const std::lock_guard lock(mutex_);
    if (!complete_) {
      if (!own_waits_ || waiting_.size() < static_cast<std::size_t>(workers)) return 0;
      std::vector<std::size_t> wanted = refined_->wanted();
      complete_ = wanted.empty();
      chunks_.refill(std::move(wanted));
      own_waits_ = false;
      next_round_.notify_all();
    }
    int ended = 0;
    std::vector<int> waiting = std::exchange(waiting_, {});
    for (const int rank : waiting) ended += answer(rank);
    return ended;
  }

  /// Sends a rank its next chunk, or lets it wait for the next round; 1 when there is nothing left for it.
  /// With the mutex held.
  int answer(int rank) {
    const batch::Chunk chunk = chunks_.next(static_cast<std::size_t>(rank));
    if (chunk.empty() && !complete_) {
      waiting_.push_back(rank);
      return 0;
    }
    mpi::send_chunk(rank, chunk);
    return chunk.empty() ? 1 : 0;
  }

  /// The next chunk of this rank; empty when nothing is left.
  batch::Chunk own_chunk() {
    while (true) {
      batch::Chunk chunk = chunks_.next(0);
      std::unique_lock lock(mutex_);
      if (!chunk.empty() || complete_) return chunk;
      own_waits_ = true;
      next_round_.wait(lock, [this] { return !own_waits_ || complete_; });
    }
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
      for (const mpi::FinishedCell& finished : report->finished) keep(finished.cell, finished.line);
    }
    if (report->signal != 0) end(report->signal);
    if (report->signal != 0) return true;
    const std::lock_guard lock(mutex_);
    return answer(report->rank) == 1;
  }

  void compute() {
    batch::Journal journal = job_.directory->journal();
    for (batch::Chunk chunk = own_chunk(); !chunk.empty(); chunk = own_chunk()) {
      sweep::run_cells(
          job_.config.study, chunk, job_.arguments.threads,
          [&](std::size_t cell, const sweep::Row& row) {
            const std::string line = report::map_line(row, job_.config.study);
            const std::lock_guard lock(mutex_);
            journal.append(cell, line);
            keep(cell, line);
          },
          ending_);
    }
  }

  /// With the mutex held.
  void keep(std::size_t cell, const std::string& line) {
    partial_.append(line);
    if (refined_) refined_->add(cell, line);
    ++finished_;
    progress_.advance();
    if (pilots_ == 0 || finished_ < pilots_) return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    progress_.say(forecast(finished_, elapsed.count(), job_.directory->missing().size() - finished_));
    pilots_ = 0;
  }

  Job& job_;
  batch::ChunkQueue chunks_;
  /// No other round comes; not of a refined map before all its cells are there. Guarded by the mutex.
  bool complete_ = true;
  std::optional<ChunkClock::time_point> ended_;  ///< when the first signal was heard of
  int signal_ = 0;
  std::atomic<bool> ending_ = false;  ///< no new cell starts
  std::mutex mutex_;                  ///< guards the journal and what follows
  std::condition_variable next_round_;
  std::optional<RefinedCells> refined_;
  bool own_waits_ = false;    ///< this rank has nothing to do before the next round
  std::vector<int> waiting_;  ///< nor have these
  batch::LineLog partial_;
  batch::Progress progress_;
  std::size_t finished_ = 0;
  std::size_t pilots_ = 0;  ///< finished cells that a forecast wants; 0: none, or no longer
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

ExitCode work(const config::RunConfig& config, int rank, int threads) {
  const std::atomic<bool>& stop = catch_interrupts();
  std::optional<batch::Journal> journal;
  std::vector<mpi::FinishedCell> finished;
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
    mpi::send_report({rank, signal, std::exchange(finished, {})});
    if (signal != 0) break;
    const batch::Chunk chunk = mpi::receive_chunk();
    if (chunk.empty()) break;
    if (!journal) journal.emplace(rank_journal(config, rank));
    sweep::run_cells(
        config.study, chunk, threads,
        [&](std::size_t cell, const sweep::Row& row) {
          std::string line = report::map_line(row, config.study);
          const std::lock_guard lock(mutex);
          journal->append(cell, line);
          finished.push_back({cell, std::move(line)});
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
  MapDirectory& directory = *job.directory;
  const bool quiet = job.arguments.quiet;
  if (!quiet && directory.finished() > 0) {
    say(fmt::format("{}: {} of {} cells were finished before\n", program_name, directory.finished(),
                    directory.cells()));
  }
  Leader leader(job, ranks);
  const std::size_t finished = leader.run(ranks - 1, stop);
  const bool refined = job.config.study.grid.refinement.has_value();
  if (refined ? leader.signal() != 0 : finished < directory.missing().size()) {
    mpi::wait_for_all();
    say(interrupted(directory, finished));
    return 128 + leader.signal();
  }
  if (!quiet) say(leader.description());
  // The others sleep meanwhile.
  const int code =
      report_map(program_name, job.arguments, directory.write_map(), job.config.study, directory);
  mpi::wait_for_all();
  return code;
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
