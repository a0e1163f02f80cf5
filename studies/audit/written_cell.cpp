#include "audit/written_cell.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <string_view>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::audit {

std::optional<CellsAndSeed> cells_and_seed(int argc, char** argv) {
  if (argc < 3) return std::nullopt;
  const auto read = [](const char* text, auto& number) {
    const char* end = text + std::strlen(text);
    return std::from_chars(text, end, number).ptr == end && end != text;
  };
  CellsAndSeed asked;
  if (!read(argv[1], asked.cells) || !read(argv[2], asked.seed)) return std::nullopt;
  for (int i = 3; i < argc; ++i) {
    const auto kind = std::ranges::find(named_stop_kinds, std::string_view(argv[i]),
                                        [](StopKind k) { return to_string(k); });
    if (kind == named_stop_kinds.end()) return std::nullopt;
    asked.kinds.push_back(*kind);
  }
  if (asked.kinds.empty()) asked.kinds.assign(stop_kinds.begin(), stop_kinds.end());
  return asked;
}

StopKind kind_of(const CellsAndSeed& asked, std::size_t i) { return asked.kinds[i % asked.kinds.size()]; }

RandomCell cell_of(const CellsAndSeed& asked, std::size_t i) {
  std::mt19937_64 random(asked.seed * 1'000'003 + i);
  return random_cell(kind_of(asked, i), random);
}

void write_cell(const RandomCell& cell, const std::string& file) {
  sweep::Study study;
  study.machine = cell.machine;
  study.grid = {{cell.speed_hz}, sweep::UnbalanceMeasure::whirl_ratio, {cell.whirl_ratio}};
  if (cell.eccentricity_m)
    study.grid = {{cell.speed_hz}, sweep::UnbalanceMeasure::eccentricity_m, {*cell.eccentricity_m}};
  std::ofstream stream(file);
  stream << config::print_study(study) << "output: {directory: map}\n";
  if (!stream.flush()) throw IoError("cannot write " + file);
}

}  // namespace rubsweep::audit
