// Errors of runs with contacts whose law is not linear: random machines against their equations in long
// double, in clearances over the growth of a disturbance. A line for each machine, then one for each law.
// With `steppers`: against runs by steppers alone, which take a hundredth of the time.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/integrate/curved_machine.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/model/normal_law.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace {

using namespace rubsweep;
using namespace rubsweep::integrate;
using test_curved::RandomMachine;
using test_curved::Reference;

struct Found {
  int hits = 0;
  double growth = 0, error = 0;
};

std::vector<double> section_of(const scene::Scene& scene, int turns, run::Method method,
                               int* hits = nullptr) {
  exact::modes::ModeCache modes;
  run::SolverOptions options;
  options.relative_tolerance = 1e-13;
  options.method = method;
  const run::Run run = start(scene, options, modes);
  run::TurnReport turn;
  for (int k = 0; k < turns; ++k) {
    if (run.advance({}, turn) != run::Outcome::ok) std::printf("a turn failed\n");
    if (hits) *hits += turn.hits;
  }
  return turn.section;
}

std::vector<double> expected_section(const RandomMachine& machine, int turns, long double moved_m,
                                     bool steppers) {
  if (steppers) {
    scene::Scene scene = machine.scene;
    scene.displacement_m(1) += double(moved_m);
    return section_of(scene, turns, run::Method::adaptive);
  }
  Reference reference = machine.reference();
  reference.longest = 1e-3L;
  reference.state[1] += moved_m;
  return reference.after_turns(turns);
}

Found examine(const RandomMachine& machine, int turns, bool steppers) {
  Found found;
  const std::vector<double> section = section_of(machine.scene, turns, run::Method::automatic, &found.hits);
  double clearance_m = 1;
  for (const model::Stop& stop : machine.stops) clearance_m = std::min(clearance_m, stop.clearance_m);
  const long double disturbance_m = steppers ? 1e-10L : 1e-12L;
  const std::vector<double> expected = expected_section(machine, turns, 0, steppers);
  const double unit_m = machine.scene.length_scale_m;
  const std::vector<double> moved = expected_section(machine, turns, disturbance_m, steppers);
  found.growth = test_curved::distance(expected, moved) * unit_m / double(disturbance_m);
  found.error = test_curved::distance(section, expected) * unit_m / clearance_m / std::max(1.0, found.growth);
  return found;
}

/// Names of a machine's laws: force, damping and friction of each contact.
std::vector<std::string> laws_of(const RandomMachine& machine) {
  std::vector<std::string> laws;
  for (std::size_t i = 0; i < machine.stops.size(); ++i) {
    const model::NormalLaw& law = machine.stops[i].law;
    laws.emplace_back(enumerator_word(law.kind));
    if (law.kind == model::ForceCurve::power) laws.back() += law.exponent == 1.5 ? " 1.5" : " other";
    laws.emplace_back(enumerator_word(law.damping));
    laws.emplace_back(machine.scene.contacts[i].friction.index() == 0 ? "no friction" : "friction");
  }
  std::ranges::sort(laws);
  laws.erase(std::unique(laws.begin(), laws.end()), laws.end());
  return laws;
}

}  // namespace

int main(int count, char** arguments) {
  const bool steppers = count == 5 && std::string_view(arguments[4]) == "steppers";
  if (count != 4 && !steppers) {
    std::printf("usage: curved_law_table FIRST LAST TURNS [steppers]\n");
    return 2;
  }
  const auto first = unsigned(std::atoi(arguments[1])), last = unsigned(std::atoi(arguments[2]));
  std::map<std::string, std::vector<double>> errors;
  std::printf("seed,hits,growth,error\n");
  for (unsigned seed = first; seed <= last; ++seed) {
    const RandomMachine machine(seed);
    const Found found = examine(machine, std::atoi(arguments[3]), steppers);
    std::printf("%u,%d,%.3g,%.2e\n", seed, found.hits, found.growth, found.error);
    std::fflush(stdout);
    errors["all"].push_back(found.error);
    for (const std::string& law : laws_of(machine)) errors[law].push_back(found.error);
  }
  std::printf("%-22s %8s %10s %10s %10s\n", "machines with", "number", "median", "largest", "above 1e-10");
  for (auto& [law, list] : errors) {
    std::ranges::sort(list);
    const auto above = std::ranges::count_if(list, [](double error) { return error > 1e-10; });
    std::printf("%-22s %8zu %10.1e %10.1e %10ld\n", law.c_str(), list.size(), list[list.size() / 2],
                list.back(), long(above));
  }
  return 0;
}
