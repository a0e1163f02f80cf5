#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/maps/batch/parallel_run.hpp"

/// Messages between the ranks of rubsweep-mpi; the only place that knows MPI. Only the thread that made the
/// Session may call. Whoever waits sleeps in between, where MPI itself would keep a processor busy.
namespace rubsweep::apps::mpi {

/// MPI as long as this lives.
class Session {
 public:
  Session(int& argc, char**& argv);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

int rank();
int ranks();

/// How many ranks run on the same machine as this one. All ranks must call it, as all that follow here.
int ranks_on_this_machine();

/// The smallest value of any rank, to all.
std::size_t smallest(std::size_t value);

/// The first rank's value, to all.
int broadcast_number(int number);
std::string broadcast_text(std::string text);

/// A finished cell and its line of the map.
struct FinishedCell {
  std::size_t cell = 0;
  std::string line;
};

/// A worker's word to the first rank: the finished cells of its last chunk, and a request for the next one
/// unless a signal ended its work.
struct Report {
  int rank = 0;
  int signal = 0;  ///< 0: none did
  std::vector<FinishedCell> finished;
};

void send_report(const Report& report);

/// The next report; empty when none came within `patience`.
std::optional<Report> receive_report(std::chrono::milliseconds patience);

/// The answer to a request; empty: nothing is left.
void send_chunk(int rank, const batch::Chunk& chunk);
batch::Chunk receive_chunk();

/// Returns when every rank has called it.
void wait_for_all();

/// Ends every rank with this exit code.
[[noreturn]] void abort(int code);

}  // namespace rubsweep::apps::mpi
