// cell_effort CONFIG.yaml TURNS SECONDS: effort for the first cell of a configuration without proofs. Prints
// closed-form steps, Taylor pieces, mode changes and processor time for consecutive stretches of doubling
// length, until TURNS turns or SECONDS seconds have passed, and how often each change happened in the last
// turn.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "bench/processor_time.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace {

using namespace rubsweep;

void print(long first, long last, const integrate::run::Effort& a, const integrate::run::Effort& b,
           double time_s) {
  const auto turns = static_cast<double>(last - first);
  const auto each = [&](long from, long to) { return static_cast<double>(to - from) / turns; };
  std::printf(
      "turns %ld to %ld: %.1f us, %.1f closed-form steps, %.1f Taylor pieces, %.1f of them creep, %.1f "
      "changes\n",
      first, last, 1e6 * time_s / turns, each(a.steps - a.taylor_pieces, b.steps - b.taylor_pieces),
      each(a.taylor_pieces, b.taylor_pieces), each(a.creep_pieces, b.creep_pieces),
      each(a.switches, b.switches));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::printf("usage: cell_effort CONFIG.yaml TURNS SECONDS\n");
    return 1;
  }
  const sweep::Study study = config::read_run_config(argv[1], {}).study;
  const scene::Place place = sweep::place_of(study.grid, 0);
  const scene::Scene scene = scene::build_cell(study.machine, place.speed_hz, place.unbalance).scene;
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(scene, study.solver, modes);
  integrate::run::TurnReport turn;
  integrate::run::Effort before;
  double begun_s = bench::processor_time_s();
  const double end_s = begun_s + std::atof(argv[3]);
  long first = 0, turns = 0;
  const long most = std::atol(argv[2]);
  integrate::run::Outcome outcome = integrate::run::Outcome::ok;
  integrate::run::TurnRequest request;
  request.switches = true;
  while (outcome == integrate::run::Outcome::ok && turns < most && bench::processor_time_s() < end_s) {
    outcome = run.advance(request, turn);
    ++turns;
    if (turns != 2 * first && turns != 1 && turns != most && outcome == integrate::run::Outcome::ok) continue;
    print(first, turns, before, turn.effort, bench::processor_time_s() - begun_s);
    first = turns;
    before = turn.effort;
    begun_s = bench::processor_time_s();
  }
  if (turns > first) print(first, turns, before, turn.effort, bench::processor_time_s() - begun_s);
  std::printf("%s\n", std::string(to_string(outcome)).c_str());
  std::map<std::string, int> changes;
  for (const auto& change : turn.switches)
    ++changes[std::to_string(change.contact) + ": " + std::string(to_string(change.from)) + " to " +
              std::string(to_string(change.to))];
  for (const auto& [name, count] : changes) std::printf("  contact %s: %d\n", name.c_str(), count);
  return 0;
}
