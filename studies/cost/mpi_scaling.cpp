// Scaling of rubsweep-mpi according to a model: the real ChunkQueue deals out cells to simulated ranks, using
// costs of cells, lines, messages and the final map that are first measured on this machine.
//   mpirun -n 2 mpi_scaling CONFIG.yaml CELLS [SAMPLED_CELLS]
// prints, for 1 to 1000 ranks with one thread each, the time of a sweep of CELLS cells and the share of it
// spent on work.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <queue>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "bench/processor_time.hpp"
#include "mpi_messages.hpp"
#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/report/map_summary.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace {

namespace fs = std::filesystem;
using namespace rubsweep;
using Clock = batch::ChunkQueue::Clock;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Measured times in seconds.
struct Costs {
  std::vector<double> cells;  ///< cells evenly spread over the map
  double line = 0;            ///< first rank, for a line of another rank
  double message = 0;         ///< first rank, for a report and its answer
  double wait = 0;            ///< from a rank's report to its next chunk, without other requests
  double row = 0;             ///< per cell of the final map
};

/// Measures cells; returns a line of the map for the other measurements.
std::string measure_cells(const sweep::Study& study, std::size_t count, Costs& costs) {
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  response::motion::Workspace workspace;
  const std::size_t cells = sweep::cell_count(study.grid), step = std::max<std::size_t>(cells / count, 1);
  std::string line;
  for (std::size_t cell = step / 2; cell < cells; cell += step) {
    const double begin = bench::processor_time_s();
    const std::string row = report::map_line(sweep::evaluate_cell(study, prepared, cell, workspace));
    costs.cells.push_back(bench::processor_time_s() - begin);
    if (row.size() > line.size()) line = row;
  }
  return line;
}

constexpr std::size_t lines_in_report = 500;
constexpr int reports = 200;

/// Does the same work with lines as Leader::keep and MapDirectory::write_map.
void measure_lines(const std::string& line, const fs::path& directory, Costs& costs) {
  std::string report;
  for (std::size_t i = 0; i < lines_in_report; ++i) report.append(line).append("\n");
  const std::size_t cells = reports * lines_in_report;
  {
    batch::LineLog partial(directory / "map.partial.csv");
    const double begin = bench::processor_time_s();
    for (int i = 0; i < reports; ++i) partial.append(std::string_view(report).substr(0, report.size() - 1));
    costs.line = (bench::processor_time_s() - begin) / static_cast<double>(cells);
  }
  batch::Journal journal(directory / "map.journal", {"study", "program", cells, "text\n"});
  for (std::size_t cell = 0; cell < cells; ++cell) journal.append(cell, line);
  const double begin = bench::processor_time_s();
  batch::FinishedCells finished(cells);
  finished.add(directory / "map.journal");
  report::MapSummary summary;
  batch::WholeFile file(directory / "map.csv");
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const std::string text = finished.text(cell);
    summary.add(text);
    file.write(text + '\n');
  }
  file.commit();
  costs.row = (bench::processor_time_s() - begin) / static_cast<double>(cells);
}

/// Exchanges reports of one line and their answers between both ranks.
void measure_messages(const std::string& line, Costs& costs) {
  const auto answer = [] {
    std::optional<apps::mpi::Report> report;
    while (!report) report = apps::mpi::receive_report(std::chrono::milliseconds(1));
    if (report->signal == 0) apps::mpi::send_chunk(1, {1});
    return *report;
  };
  std::vector<double> waits;
  if (apps::mpi::rank() == 0) {
    // All at once, so that the first rank does not sleep.
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    std::vector<double> each;
    for (int i = 0; i < reports; ++i) {
      const double begin = bench::processor_time_s();
      answer();
      each.push_back(bench::processor_time_s() - begin);
    }
    costs.message = median(each);
    for (int i = 0; i < reports; ++i) answer();
    costs.wait = std::stod(answer().finished.front().line);
    return;
  }
  for (int i = 0; i < reports; ++i) apps::mpi::send_report({.rank = 1, .finished = {{0, line}}});
  for (int i = 0; i < reports; ++i) apps::mpi::receive_chunk();
  // One by one, as from a rank that computes while the first one sleeps, at varying moments.
  for (int i = 0; i < reports; ++i) {
    std::this_thread::sleep_for(std::chrono::microseconds(3000 + 37 * (i % 27)));
    const auto sent = Clock::now();
    apps::mpi::send_report({.rank = 1, .finished = {{0, line}}});
    apps::mpi::receive_chunk();
    waits.push_back(std::chrono::duration<double>(Clock::now() - sent).count());
  }
  apps::mpi::send_report({.rank = 1, .signal = 15, .finished = {{0, fmt::format("{}", median(waits))}}});
}

struct Outcome {
  double computed_s = 0;  ///< time at which the last rank finished
  double leader_s = 0;    ///< time that the first rank spent for others
};

/// Simulates ranks with one thread each; the first rank serves the others while its other thread computes.
Outcome simulate(const Costs& costs, std::size_t cells, std::size_t ranks) {
  std::vector<std::size_t> all(cells);
  for (std::size_t i = 0; i < cells; ++i) all[i] = i;
  batch::ChunkQueue queue(std::move(all), ranks);
  struct Report {
    double at_s;
    std::size_t rank, lines;
    bool operator>(const Report& other) const { return at_s > other.at_s; }
  };
  std::priority_queue<Report, std::vector<Report>, std::greater<>> waiting;
  for (std::size_t rank = 0; rank < ranks; ++rank) waiting.push({0, rank, 0});
  Outcome outcome;
  double leader_free_s = 0;
  while (!waiting.empty()) {
    const Report report = waiting.top();
    waiting.pop();
    double chunk_at_s = report.at_s;
    if (report.rank > 0) {
      const double work_s = costs.message + static_cast<double>(report.lines) * costs.line;
      outcome.leader_s += work_s;
      // A first rank without work sleeps; one with waiting reports does not.
      leader_free_s = std::max(leader_free_s, report.at_s) + work_s;
      chunk_at_s = std::max(leader_free_s, report.at_s + costs.wait);
    }
    const auto now = Clock::time_point(
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(chunk_at_s)));
    const batch::Chunk chunk = queue.next(report.rank, now);
    double done_s = chunk_at_s;
    for (const std::size_t cell : chunk) done_s += costs.cells[cell * costs.cells.size() / cells];
    outcome.computed_s = std::max(outcome.computed_s, done_s);
    if (!chunk.empty()) waiting.push({done_s, report.rank, chunk.size()});
  }
  return outcome;
}

void print(const Costs& costs, std::size_t cells) {
  double sampled_s = 0;
  for (const double cost : costs.cells) sampled_s += cost;
  const double mean_s = sampled_s / static_cast<double>(costs.cells.size());
  fmt::print(
      "{} cells of {:.3g} ms (longest of {}: {:.3g} ms), a line {:.2g} us, a message {:.2g} us, a wait "
      "{:.2g} ms, a row of the map {:.2g} us\n",
      cells, 1e3 * mean_s, costs.cells.size(),
      1e3 * *std::max_element(costs.cells.begin(), costs.cells.end()), 1e6 * costs.line, 1e6 * costs.message,
      1e3 * costs.wait, 1e6 * costs.row);
  fmt::print(
      "| ranks | computed after, s | with the map, s | efficiency | without the map | first rank busy |\n"
      "|---|---|---|---|---|---|\n");
  double one_s = 0;
  for (std::size_t i = 0; i < cells; ++i) one_s += costs.cells[i * costs.cells.size() / cells];
  const double map_s = costs.row * static_cast<double>(cells);
  for (const std::size_t ranks : {1u, 2u, 10u, 30u, 100u, 300u, 1000u}) {
    const Outcome outcome = simulate(costs, cells, ranks);
    const double ideal_s = one_s / static_cast<double>(ranks);
    fmt::print("| {} | {:.4g} | {:.4g} | {:.1f} % | {:.1f} % | {:.1f} % |\n", ranks, outcome.computed_s,
               outcome.computed_s + map_s, 100 * ideal_s / (outcome.computed_s + map_s),
               100 * ideal_s / outcome.computed_s, 100 * outcome.leader_s / outcome.computed_s);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const apps::mpi::Session session(argc, argv);
  if (argc < 3 || apps::mpi::ranks() != 2) {
    fmt::print(stderr, "mpirun -n 2 mpi_scaling CONFIG.yaml CELLS [SAMPLED_CELLS]\n");
    return 1;
  }
  Costs costs;
  std::string line(300, 'x');
  measure_messages(line, costs);
  if (apps::mpi::rank() == 0) {
    const auto study = config::read_run_config(argv[1], {}).study;
    line = measure_cells(study, argc > 3 ? std::stoul(argv[3]) : sweep::cell_count(study.grid), costs);
    const fs::path directory = fs::temp_directory_path() / fmt::format("mpi_scaling_{}", ::getpid());
    fs::create_directory(directory);
    measure_lines(line, directory, costs);
    fs::remove_all(directory);
    print(costs, std::stoul(argv[2]));
  }
  apps::mpi::wait_for_all();
  return 0;
}
