// every_scene CONFIG...: compares the solver chosen by `auto` with a long double run in six cells of each
// configuration's map. Prints the error of the section after the kick and six turns, in clearances, and this
// error divided by the growth of small changes. It also prints the error of the long double run itself (its
// change at a tolerance a hundred times larger), and the error of the last turn's monodromy matrix divided by
// its largest entry.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "rubsweep/maps/config/run_config.hpp"
#include "support/long_double_errors.hpp"
#include "support/map_cell.hpp"

namespace {

using namespace rubsweep;
constexpr int turns = 6;

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void print(const std::filesystem::path& file) {
  const sweep::Study study = config::read_run_config(file, {}).study;
  std::vector<double> section, over_growth, reference, monodromy;
  int touched = 0;
  for (const double unbalance : {0.3, 0.7}) {
    for (const double speed : {0.15, 0.4, 0.7}) {
      const scene::Cell cell = test::build_map_cell(study, test::map_cell(study.grid, speed, unbalance));
      if (!scene::can_run(cell.start)) continue;
      const test::LongDoubleErrors e = test::errors_against_long_double(cell.scene, study.solver, turns);
      touched += e.touched ? 1 : 0;
      section.push_back(e.section);
      over_growth.push_back(e.over_growth);
      reference.push_back(e.reference);
      monodromy.push_back(e.monodromy);
    }
  }
  if (section.empty()) return;
  const auto largest = [](const std::vector<double>& v) { return *std::max_element(v.begin(), v.end()); };
  std::printf("%-40s %d %zu  %.1e %.1e %.1e  %.1e  %.1e %.1e\n", file.c_str(), touched, section.size(),
              median(section), largest(section), largest(over_growth), largest(reference), median(monodromy),
              largest(monodromy));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::printf("usage: every_scene CONFIG...\n");
    return 1;
  }
  std::printf(
      "%-40s touch cells  section: median largest over growth  reference  monodromy: median largest\n",
      "configuration");
  for (int i = 1; i < argc; ++i) print(argv[i]);
  return 0;
}
