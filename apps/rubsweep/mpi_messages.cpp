#include "mpi_messages.hpp"

#include <mpi.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace rubsweep::apps::mpi {
namespace {

constexpr int report_tag = 1, chunk_tag = 2;
constexpr auto nap = std::chrono::microseconds(200);

/// Status, which tells the size, of a waiting message with this tag; empty where none waits.
std::optional<MPI_Status> waiting_message(int source, int tag) {
  int there = 0;
  MPI_Status status{};
  MPI_Iprobe(source, tag, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  return status;
}

template <class Container>
Container receive(const MPI_Status& status, MPI_Datatype type) {
  int length = 0;
  MPI_Get_count(&status, type, &length);
  Container content(static_cast<std::size_t>(length), {});
  MPI_Recv(content.data(), length, type, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return content;
}

}  // namespace

Session::Session(int& argc, char**& argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
}

Session::~Session() { MPI_Finalize(); }

int rank() {
  int value = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &value);
  return value;
}

int ranks() {
  int value = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &value);
  return value;
}

int ranks_on_this_machine() {
  MPI_Comm machine{};
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int value = 0;
  MPI_Comm_size(machine, &value);
  MPI_Comm_free(&machine);
  return value;
}

std::size_t smallest(std::size_t value) {
  std::uint64_t result = value;
  MPI_Allreduce(MPI_IN_PLACE, &result, 1, MPI_UINT64_T, MPI_MIN, MPI_COMM_WORLD);
  return result;
}

int broadcast_number(int number) {
  MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return number;
}

std::string broadcast_text(std::string text) {
  text.resize(static_cast<std::size_t>(broadcast_number(static_cast<int>(text.size()))));
  MPI_Bcast(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  return text;
}

void send_report(const Report& report) {
  std::string text = std::to_string(report.signal);
  for (const FinishedCell& finished : report.finished)
    text.append("\n").append(std::to_string(finished.cell)).append(" ").append(finished.line);
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, report_tag, MPI_COMM_WORLD);
}

std::optional<Report> receive_report(std::chrono::milliseconds patience) {
  auto status = waiting_message(MPI_ANY_SOURCE, report_tag);
  if (!status) {
    std::this_thread::sleep_for(patience);
    status = waiting_message(MPI_ANY_SOURCE, report_tag);
    if (!status) return std::nullopt;
  }
  const auto text = receive<std::string>(*status, MPI_CHAR);
  Report report{status->MPI_SOURCE, std::stoi(text), {}};
  for (std::size_t end = text.find('\n'); end != std::string::npos;) {
    const std::size_t begin = end + 1, blank = text.find(' ', begin);
    end = text.find('\n', begin);
    report.finished.push_back({std::stoul(text.substr(begin, blank - begin)),
                               text.substr(blank + 1, end == std::string::npos ? end : end - blank - 1)});
  }
  return report;
}

void send_chunk(int rank, const batch::Chunk& chunk) {
  const std::vector<std::uint64_t> cells(chunk.begin(), chunk.end());
  MPI_Send(cells.data(), static_cast<int>(cells.size()), MPI_UINT64_T, rank, chunk_tag, MPI_COMM_WORLD);
}

batch::Chunk receive_chunk() {
  auto status = waiting_message(0, chunk_tag);
  for (; !status; status = waiting_message(0, chunk_tag)) std::this_thread::sleep_for(nap);
  const auto cells = receive<std::vector<std::uint64_t>>(*status, MPI_UINT64_T);
  return {cells.begin(), cells.end()};
}

void wait_for_all() {
  MPI_Request request{};
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  for (int there = 0; there == 0;) {
    MPI_Test(&request, &there, MPI_STATUS_IGNORE);
    if (there == 0) std::this_thread::sleep_for(nap);
  }
}

void abort(int code) {
  MPI_Abort(MPI_COMM_WORLD, code);
  std::abort();
}

}  // namespace rubsweep::apps::mpi
