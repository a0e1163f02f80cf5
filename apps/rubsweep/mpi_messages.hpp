#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/maps/batch/parallel_run.hpp"

/// Messages between the ranks of rubsweep-mpi; MPI is used nowhere else. Only the thread that made the
/// Session may call these functions. A waiting rank sleeps between checks, whereas MPI itself would keep a
/// processor busy.
namespace rubsweep::apps::mpi {

/// Initialises MPI and finalises it at the end of its lifetime.
class Session {
 public:
  Session(int& argc, char**& argv);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

int rank();
int ranks();

/// Number of ranks on this machine. Like the functions below, all ranks must call it.
int ranks_on_this_machine();

/// The smallest `value` of all ranks, returned to all of them.
std::size_t smallest(std::size_t value);

/// Sends the first rank's value to all ranks.
int broadcast_number(int number);
std::string broadcast_text(std::string text);

/// A finished cell and its line in map.csv.
struct FinishedCell {
  std::size_t cell = 0;
  std::string line;
};

/// Message of a worker to the first rank: the finished cells of its last chunk, and a request for the next
/// one unless a signal ended its work.
struct Report {
  int rank = 0;
  int signal = 0;  ///< 0: no signal
  std::vector<FinishedCell> finished;
};

void send_report(const Report& report);

/// The next report; empty if none comes within `patience`.
std::optional<Report> receive_report(std::chrono::milliseconds patience);

/// Sends the answer to a request; an empty chunk means that there is no more work.
void send_chunk(int rank, const batch::Chunk& chunk);
batch::Chunk receive_chunk();

/// Returns when every rank has called this function.
void wait_for_all();

/// Ends all ranks with this exit code.
[[noreturn]] void abort(int code);

}  // namespace rubsweep::apps::mpi
