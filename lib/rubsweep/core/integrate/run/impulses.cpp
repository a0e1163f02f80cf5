#include "rubsweep/core/integrate/run/impulses.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::integrate::run {
namespace {

const double last_phase = std::nextafter(numerics::full_turn, 0.0);

}  // namespace

/// Number of the first impulse at or after the start of a revolution. Despite rounding, no impulse is lost
/// between two revolutions, and none belongs to both.
Impulses::TrainPosition Impulses::position(const Train& train, long revolution) {
  const double periods = static_cast<double>(revolution) * train.multiple, whole = std::floor(periods);
  const double rest = periods - whole;
  return {whole, rest, train.phase_periods >= rest ? whole : whole + 1};
}

Impulses::Impulses(const scene::Scene& scene) : elapsed_revolutions_(scene.elapsed_revolutions) {
  if (scene.impulses.empty()) return;
  const numerics::dense::SymmetricFactors mass(scene.structure.mass);
  std::size_t most = 0;
  for (const auto& train : scene.impulses) {
    trains_.push_back({mass.solve(train.impulse_ns), train.multiple, train.phase_periods});
    most += static_cast<std::size_t>(std::ceil(train.multiple)) + 1;
  }
  instants_.reserve(most);
}

void Impulses::begin_turn(long revolution) {
  instants_.clear();
  next_ = 0;
  for (std::size_t i = 0; i < trains_.size(); ++i) {
    const Train& train = trains_[i];
    const TrainPosition begin = position(train, elapsed_revolutions_ + revolution),
                        end = position(train, elapsed_revolutions_ + revolution + 1);
    for (double k = begin.next; k < end.next; ++k) {
      const double periods = k - begin.whole + train.phase_periods - begin.rest;
      instants_.push_back({std::clamp(numerics::full_turn * (periods / train.multiple), 0.0, last_phase), i});
    }
  }
  if (trains_.size() > 1)
    std::ranges::sort(instants_,
                      [](const Instant& a, const Instant& b) { return a.phase_rad < b.phase_rad; });
}

bool same_every_turn(const scene::Scene& scene) {
  return std::ranges::all_of(scene.impulses,
                             [](const auto& train) { return train.multiple == std::floor(train.multiple); });
}

bool remembers_impacts(const scene::Scene& scene) {
  return std::ranges::any_of(scene.contacts, [](const auto& c) { return c.law && c.law->remembers(); });
}

}  // namespace rubsweep::integrate::run
