#include <fmt/format.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "map_options.hpp"
#include "map_outcome.hpp"
#include "mpi_leader.hpp"
#include "mpi_messages.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/report/describe_grid.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/footprint.hpp"
#include "rubsweep/maps/sweep/run_cells.hpp"
#include "rubsweep_arguments.hpp"
#include "shared/command_line.hpp"
#include "shared/exit_code.hpp"
#include "shared/figure.hpp"
#include "shared/interrupt.hpp"
#include "shared/kept_files.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"
#include "shared/run_summary.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// Options of rubsweep that apply to rubsweep-mpi, too.
po::options_description options_of_a_map() {
  po::options_description options("Options");
  add_map_files(options);
  add_threads(options, "threads of each process; 0: one per processor");
  add_set(options);
  add_fresh(options);
  add_report(options);
  add_progress(options);
  add_last(options);
  return options;
}

std::string help() {
  return fmt::format(
      "mpirun -n N rubsweep-mpi CONFIG.yaml [options]\n"
      "Computes one map with N processes that share the output directory.\n\n"
      "{}\n"
      "Examples:\n"
      "  mpirun -n 4 rubsweep-mpi configs/benchmark/one_side.yaml --threads 1\n\n"
      "The map is the same, byte for byte, as that of rubsweep, and so is what happens when a run ends "
      "early: the same\n"
      "command, with any number of processes, computes the rest. The first process draws the picture and "
      "writes report.html,\n"
      "on --threads threads. rubsweep --help explains the columns and classes of the map.\n\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration, or DIR holds cells or a map of another one; 3 "
      "input/output;\n"
      "4 done, but some cells failed; 6 another process is at work in DIR; 70 out of memory or a fault of "
      "the "
      "program; 128+signal\n"
      "when interrupted.\n",
      text_of(options_of_a_map()));
}

/// Prepares the work; returns an exit code. `job` is set if the code is `done` and the map still has to be
/// computed. Each rank may use `memory_bytes`.
int prepare(int argc, char** argv, int ranks, std::size_t memory_bytes, std::optional<MapJob>& job) {
  RubsweepArguments arguments = parse_rubsweep_arguments(argc, argv);
  if (answered(mpi_program_name, arguments.action, help)) return done;
  if (arguments.action != Action::run || arguments.shard || arguments.merge || arguments.verified ||
      arguments.status || arguments.watched || arguments.matrices || arguments.key_answer ||
      arguments.motion_kinds) {
    throw UsageError("this program only computes maps; use rubsweep for everything else");
  }
  config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  ask(mpi_program_name, config.questions, arguments.quiet);
  refuse_fading(arguments, config.study);
  report::refuse_more_memory_than(memory_bytes, config.study,
                                  {batch::thread_count(arguments.threads), ranks});
  config.output_directory = fs::absolute(arguments.output.value_or(config.output_directory));
  keep_run_configuration(arguments.config, config.output_directory);
  refuse_what_cannot_be_shown(arguments, config.study, config.output_directory);
  job.emplace();
  job->arguments = std::move(arguments);
  job->config = std::move(config);
  job->directory.emplace(job->config.output_directory, job->config, std::nullopt, job->arguments.fresh,
                         std::string(mpi_program_name));
  if (const auto& map = job->directory->finished_map()) {
    if (!job->arguments.quiet) say(map::map_is_there(mpi_program_name));
    const int code = report_map(mpi_program_name, job->arguments, map->summary, job->config, *job->directory);
    job.reset();
    return code;
  }
  const sweep::Study& study = job->config.study;
  if (!job->arguments.quiet)
    warn_of_premises(mpi_program_name, study, job->prepared.emplace(scene::prepare_machine(study.machine)));
  return done;
}

ExitCode work(const config::RunConfig& config, int rank, int threads) {
  const std::atomic<bool>& stop = catch_interrupts();
  std::optional<batch::Journal> journal;
  std::optional<scene::PreparedMachine> prepared;
  std::vector<mpi::FinishedCell> finished;
  std::mutex mutex;  // guards the journal
  // A rank that computes a long cell cannot report. It exits instead, which ends the MPI job and sends the
  // other ranks a signal.
  std::optional<Watch> watch(
      std::in_place,
      [&] {
        const std::lock_guard lock(mutex);
        if (journal) journal->refresh();
      },
      [&] {
        const std::lock_guard lock(mutex);
        if (journal) journal->sync();
        std::_Exit(128 + caught_signal());
      });
  while (true) {
    const int signal = caught_signal();  // read once, so that the reported signal is the one acted upon
    mpi::send_report({rank, signal, std::exchange(finished, {})});
    if (signal != 0) break;
    const batch::Chunk chunk = mpi::receive_chunk();
    if (chunk.empty()) break;
    if (const std::lock_guard lock(mutex); !journal) journal.emplace(map::rank_journal(config, rank));
    if (!prepared) prepared = scene::prepare_machine(config.study.machine);
    sweep::run_cells(
        config.study, *prepared, chunk, threads,
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
  mpi::wait_for_all();  // the first rank reads the journals after this
  mpi::wait_for_all();  // the first rank writes and draws the map before this
  return done;
}

int lead(MapJob& job, int ranks) {
  const std::atomic<bool>& stop = catch_interrupts();
  map::MapDirectory& directory = *job.directory;
  const bool quiet = job.arguments.quiet;
  if (!quiet && directory.finished() > 0) {
    say(fmt::format("{}: {} of {} cells were finished before\n", mpi_program_name, directory.finished(),
                    directory.cells()));
  }
  MpiLeader leader(job, ranks);
  const std::size_t finished = leader.run(ranks - 1, stop);
  mpi::wait_for_all();  // all journals are closed after this
  const bool refined = job.config.study.grid.refinement.has_value();
  if (refined ? leader.signal() != 0 : finished < directory.missing().size()) {
    mpi::wait_for_all();
    say(map::interrupted_map(mpi_program_name, directory, finished));
    return 128 + leader.signal();
  }
  if (!quiet) say(leader.description());
  // The other ranks sleep meanwhile.
  const int code = report_map(mpi_program_name, job.arguments, directory.write_map(), job.config, directory);
  mpi::wait_for_all();
  return code;
}

int run(int argc, char** argv) {
  const int rank = mpi::rank(), ranks = mpi::ranks();
  const std::size_t memory_bytes =
      mpi::smallest(batch::machine_memory_bytes() / static_cast<std::size_t>(mpi::ranks_on_this_machine()));
  std::optional<MapJob> job;
  int code = 0;
  hold_summary(true);
  if (rank == 0) {
    code = run_program(mpi_program_name, [&] { return prepare(argc, argv, ranks, memory_bytes, job); });
  }
  code = mpi::broadcast_number(code);
  const int threads = mpi::broadcast_number(job ? job->arguments.threads : 0);
  hold_summary(false);
  const std::string text = mpi::broadcast_text(job ? config::print_config(job->config) : "");
  if (code != done || text.empty()) return run_program(mpi_program_name, [&] { return code; });
  code = run_program(mpi_program_name, [&] {
    batch::require_threads(threads, 1);
    if (job) return lead(*job, ranks);
    return static_cast<int>(work(config::read_run_config_text(text, "the first rank", {}), rank, threads));
  });
  // The other ranks would wait forever for a rank that gave up; the journals are already with the operating
  // system.
  if (code != done && code != some_cells_failed && code < 128) mpi::abort(code);
  return code;
}

/// Whether this process was started alone: mpirun and srun set one of these variables.
bool started_alone() {
  return std::getenv("PMIX_RANK") == nullptr && std::getenv("PMI_RANK") == nullptr &&
         std::getenv("OMPI_COMM_WORLD_RANK") == nullptr;
}

/// Exit code if the arguments ask for the help or the version, or are no arguments of this program. All of
/// these are answered without MPI, because a session of Open MPI fails where another one begins at the same
/// moment, or where it cannot write to TMPDIR.
std::optional<int> answer_without_mpi(int argc, char** argv) {
  bool is_answered = false;
  hold_summary(true);
  const int code = run_program(mpi_program_name, [&] {
    is_answered = answered(mpi_program_name, parse_rubsweep_arguments(argc, argv).action, help);
    return done;
  });
  hold_summary(false);
  if (!is_answered && code == done) return std::nullopt;
  return run_program(mpi_program_name, [&] { return code; });
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  rubsweep::apps::open_standard_descriptors();
  if (rubsweep::apps::started_alone()) {
    if (const auto code = rubsweep::apps::answer_without_mpi(argc, argv)) return *code;
  }
  const rubsweep::apps::mpi::Session session(argc, argv);
  return rubsweep::apps::run(argc, argv);
}
