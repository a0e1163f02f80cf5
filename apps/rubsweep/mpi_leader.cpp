#include "mpi_leader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <thread>
#include <utility>

#include "mpi_messages.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/report/describe_grid.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/run_cells.hpp"
#include "shared/interrupt.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {

MpiLeader::MpiLeader(MapJob& job, int ranks)
    : job_(job),
      chunks_(job.directory->missing(), static_cast<std::size_t>(ranks),
              job.config.study.grid.refinement.has_value()),
      log_(*job.directory, job.arguments.quiet ? batch::ProgressMode::never : job.arguments.progress) {
  const int threads = batch::thread_count(job.arguments.threads);
  const sweep::Study& study = job.config.study;
  if (!job.prepared) job.prepared = scene::prepare_machine(study.machine);
  if (study.grid.refinement) {
    refined_.emplace(study.grid);
    refined_->read(*job.directory);
    chunks_.begin_round(refined_->wanted());
    log_.progress().say(report::describe_footprint(study, *job.prepared, {threads, ranks}));
    return;
  }
  const sweep::Grid& grid = study.grid;
  const std::size_t cells = job.directory->missing().size(), speeds = grid.speed_hz.size();
  log_.progress().expect({speeds, sweep::cell_count(grid) / speeds, job.directory->missing()});
  // The first cells are spread over the whole map, to predict the computing time for a reader of the
  // progress.
  if (log_.progress().say(report::describe_footprint(study, *job.prepared, {threads, ranks})))
    pilots_ = batch::pilot_count(cells, static_cast<std::size_t>(threads) * static_cast<std::size_t>(ranks));
}

std::size_t MpiLeader::run(int workers, const std::atomic<bool>& stop) {
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
      if (ended_ && Clock::now() - *ended_ >= grace) leave();
      const std::lock_guard lock(mutex_);
      log_.refresh();
    }
  } catch (...) {
    give_up();  // without this the destructor would wait for all cells
    throw;
  }
  own.join();
  if (failure) std::rethrow_exception(failure);
  log_.progress().finish();
  return log_.finished();
}

void MpiLeader::end(int signal) {
  if (ended_) return;
  ended_ = Clock::now();
  signal_ = signal;
  ending_ = true;
  give_up();
}

void MpiLeader::give_up() {
  const std::lock_guard lock(mutex_);
  chunks_.give_up();
  next_round_.notify_all();
}

int MpiLeader::begin_round(int workers) {
  const std::lock_guard lock(mutex_);
  if (!chunks_.is_last()) {
    if (chunks_.waiting() < static_cast<std::size_t>(workers) + 1) return 0;
    chunks_.begin_round(refined_->wanted());
  }
  int ended = 0;
  for (const std::size_t rank : chunks_.take_waiting()) {
    if (rank == 0) {
      next_round_.notify_all();
    } else {
      ended += answer(static_cast<int>(rank));
    }
  }
  return ended;
}

int MpiLeader::answer(int rank) {
  const auto chunk = chunks_.next(static_cast<std::size_t>(rank));
  if (!chunk) return 0;
  mpi::send_chunk(rank, *chunk);
  return chunk->empty() ? 1 : 0;
}

batch::Chunk MpiLeader::own_chunk() {
  std::unique_lock lock(mutex_);
  while (true) {
    if (auto chunk = chunks_.next(0)) return *std::move(chunk);
    next_round_.wait(lock, [this] { return !chunks_.waits(0) || chunks_.is_last(); });
  }
}

void MpiLeader::leave() {
  const std::lock_guard lock(mutex_);
  log_.close();
  say(map::interrupted_map(mpi_program_name, *job_.directory, log_.finished()));
  job_.directory->leave();
  mpi::abort(128 + signal_);
}

bool MpiLeader::serve() {
  const auto report = mpi::receive_report(std::chrono::milliseconds(1));
  if (!report) return false;
  {
    const std::lock_guard lock(mutex_);
    for (const mpi::FinishedCell& finished : report->finished) {
      log_.add_of_other_process(finished.cell, finished.line);
      note(finished.cell, finished.line);
    }
  }
  if (report->signal != 0) end(report->signal);
  if (report->signal != 0) return true;
  const std::lock_guard lock(mutex_);
  return answer(report->rank) == 1;
}

void MpiLeader::compute() {
  const sweep::Study& study = job_.config.study;
  for (batch::Chunk chunk = own_chunk(); !chunk.empty(); chunk = own_chunk()) {
    const batch::LapTime time;
    sweep::run_cells(
        study, *job_.prepared, chunk, job_.arguments.threads,
        [&](std::size_t cell, const sweep::Row& row) {
          const double seconds = time.lap_s();
          const std::string line = report::map_line(row, study);
          const std::lock_guard lock(mutex_);
          log_.add(cell, line, seconds);
          note(cell, line);
        },
        ending_);
  }
}

void MpiLeader::note(std::size_t cell, const std::string& line) {
  if (refined_) refined_->add(cell, line);
  const std::size_t finished = log_.finished();
  if (pilots_ == 0 || finished < pilots_) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const std::size_t left = job_.directory->missing().size() - finished;
  if (const std::string text = batch::forecast(finished, elapsed.count(), left); !text.empty())
    log_.progress().say(text);
  pilots_ = 0;
}

}  // namespace rubsweep::apps
