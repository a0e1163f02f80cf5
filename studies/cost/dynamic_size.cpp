// dynamic_size: compares the cost of an exact turn with a number of coordinates known only at run time, as in
// a rotor kit, with that of a number known to the compiler.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "bench/processor_time.hpp"
#include "core/scene/one_side_machine.hpp"
#include "rubsweep/core/integrate/exact/exact_run.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace {

using namespace rubsweep;
using integrate::run::Outcome;

constexpr int settling = 300, turns = 3000, repeats = 5;

struct Watched {
  const char* name;
  integrate::run::TurnRequest request;
};

/// Median time over several stretches of the settled motion, microseconds per turn; also gives the last
/// section.
template <int N>
double turn_us(const scene::Scene& scene, const integrate::run::TurnRequest& request,
               std::vector<double>& section) {
  integrate::exact::ExactRun<N> run(scene, std::make_shared<integrate::exact::modes::MachineModes<N>>(scene),
                                    1'000'000);
  integrate::run::TurnReport report;
  const auto advance = [&](int count) {
    for (int k = 0; k < count; ++k) {
      if (run.advance(request, report) != Outcome::ok) std::printf("a turn without closed form\n");
    }
  };
  advance(settling);
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const double start_s = bench::processor_time_s();
    advance(turns);
    times.push_back(1e6 * (bench::processor_time_s() - start_s) / turns);
  }
  std::ranges::sort(times);
  section = run.section();
  return times[repeats / 2];
}

template <int N>
void compare(const scene::Scene& scene) {
  Watched plain{"nothing", {}}, watched{"peaks, 32 samples", {}}, tangents{"all tangent vectors", {}};
  watched.request.peaks = true;
  watched.request.samples_per_revolution = 32;
  tangents.request.tangent_vectors.setIdentity(2 * N, 2 * N);
  for (const Watched& asked : {plain, watched, tangents}) {
    std::vector<double> fixed_section, section;
    const double fixed_us = turn_us<N>(scene, asked.request, fixed_section);
    const double dynamic_us = turn_us<Eigen::Dynamic>(scene, asked.request, section);
    double apart = 0;
    for (std::size_t i = 0; i < section.size(); ++i)
      apart = std::max(apart, std::abs(section[i] - fixed_section[i]));
    std::printf("| %d | %s | %.2f | %.2f | %.2f | %.1e |\n", N, asked.name, fixed_us, dynamic_us,
                dynamic_us / fixed_us, apart);
  }
}

}  // namespace

int main() {
  std::printf("| coordinates | asked for | fixed, us | dynamic, us | ratio | sections apart by |\n");
  std::printf("|---|---|---|---|---|---|\n");
  compare<4>(scene::build_cell(scene::one_side_machine(), 75, scene::WhirlRatio{0.4}).scene);
  compare<6>(scene::build_cell(scene::both_sides_machine(), 75, scene::WhirlRatio{0.4}).scene);
}
