// machine_search GRID SEED RANDOM NEARBY [KEPT [START.csv]]: searches for one machine whose five maps show as
// many findings of Ishibashi & Kawai as possible, on one of three coarse grids (0 to 2). Evaluates the
// starting points, RANDOM machines drawn from the ranges of candidate.hpp, and NEARBY machines near the KEPT
// (10) best ones. START.csv lists further machines to begin with, using the names of the printed columns;
// with RANDOM and NEARBY 0 only these are evaluated. Prints one CSV line per machine; `complete` marks
// machines that were not given up early. Uses one thread; apart from the processor time, the lines depend on
// the arguments alone.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "machine_search/evaluation.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace {

using namespace rubsweep::machine_search;

/// First bar, out of 29 marks: machines below it are useless.
constexpr double least_score = 14;

class Search {
 public:
  Search(std::size_t grid, std::size_t kept) : grid_(grid), kept_(kept) {}

  void look_at(const Candidate& candidate, const char* origin) {
    const double bar = best_.size() < kept_ ? least_score : best_.back().first;
    const Evaluation evaluation = evaluate(candidate, grid_, bar);
    print(candidate, origin, evaluation);
    if (!evaluation.complete) return;
    best_.emplace_back(evaluation.score, candidate);
    std::stable_sort(best_.begin(), best_.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    if (best_.size() > kept_) best_.resize(kept_);
  }

  bool found_some() const { return !best_.empty(); }

  /// Returns one of the best candidates, preferring better ones.
  const Candidate& one_of_the_best(std::mt19937_64& random) const {
    const std::size_t first = random() % best_.size(), second = random() % best_.size();
    return best_[std::min(first, second)].second;
  }

 private:
  void print(const Candidate& candidate, const char* origin, const Evaluation& evaluation) {
    if (tried_ == 0) {
      std::string header = "machine,origin";
      for (const Parameter& parameter : parameters) header += fmt::format(",{}", parameter.name);
      fmt::print("{},score,processor_s,complete,marks\n", header);
    }
    std::string line = fmt::format("{},{}", tried_++, origin);
    for (const Parameter& parameter : parameters) line += fmt::format(",{:.6g}", candidate.*parameter.field);
    line += fmt::format(",{:.3f},{:.2f},{},", evaluation.score, evaluation.processor_s, evaluation.complete);
    for (const Mark& mark : evaluation.marks)
      line += fmt::format("{} {:g} {:.2f};", mark.finding, mark.verdict, mark.nearness);
    fmt::print("{}\n", line);
    std::fflush(stdout);
  }

  std::size_t grid_;
  std::size_t kept_;
  std::size_t tried_ = 0;
  std::vector<std::pair<double, Candidate>> best_;
};

std::optional<std::size_t> whole_number(const char* text) {
  std::size_t number = 0;
  const char* end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, number);
  return error == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

std::vector<Candidate> candidates_in(const char* path) {
  rubsweep::batch::CsvReader rows(path);
  std::vector<Candidate> candidates;
  while (rows.next()) {
    Candidate& candidate = candidates.emplace_back();
    for (const Parameter& parameter : parameters)
      candidate.*parameter.field = rows.number(rows.column(parameter.name));
  }
  return candidates;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::size_t> numbers;
  for (int i = 1; i < std::min(argc, 6); ++i) {
    if (const auto number = whole_number(argv[i])) numbers.push_back(*number);
  }
  if (argc < 5 || argc > 7 || numbers.size() + 1 != static_cast<std::size_t>(std::min(argc, 6)) ||
      numbers[0] >= grid_count || (argc >= 6 && numbers[4] == 0)) {
    fmt::print(stderr, "usage: machine_search GRID SEED RANDOM NEARBY [KEPT [START.csv]]\n");
    return 1;
  }
  try {
    std::mt19937_64 random(numbers[1]);
    Search search(numbers[0], numbers.size() == 5 ? numbers[4] : 10);
    if (argc == 7) {
      for (const Candidate& candidate : candidates_in(argv[6])) search.look_at(candidate, "file");
    } else {
      for (const Candidate& candidate : starting_points) search.look_at(candidate, "start");
    }
    for (std::size_t i = 0; i < numbers[2]; ++i) search.look_at(random_candidate(random), "random");
    for (std::size_t i = 0; i < numbers[3] && search.found_some(); ++i) {
      const double spread = i % 2 == 0 ? 0.1 : 0.4;
      search.look_at(perturbed(search.one_of_the_best(random), spread, random), "nearby");
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "machine_search: {}\n", error.what());
    return 3;
  }
  return 0;
}
