#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <tuple>
#include <vector>

#include "rubsweep/integrate/exact/machine_modes.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate::exact {

/// Default capacity of a ModeCache.
inline constexpr std::size_t most_bytes_of_a_mode_cache = std::size_t{256} << 20;

/// Least-recently-used cache of the modes of machines, so that runs of one machine at other unbalances need
/// not factorise again: a rotor whose gyroscopic forces grow with the speed is another machine at each speed,
/// and a map comes back to every speed once a row. Belongs to one thread.
class ModeCache {
 public:
  /// Drops the machines unused for longest until the cache holds no more than this; the machine asked for
  /// stays. A kit of 24 states takes about 1 MB a speed, one of 200 states 100.
  explicit ModeCache(std::size_t most_bytes = most_bytes_of_a_mode_cache) : most_bytes_(most_bytes) {}

  template <int N>
  std::shared_ptr<MachineModes<N>> modes_of(const scene::Scene& scene) {
    auto& recent = std::get<Recent<N>>(recent_);
    auto found = std::ranges::find_if(recent, [&](const auto& modes) { return modes->fits(scene); });
    if (found != recent.end() && found == recent.begin()) return *found;
    if (found == recent.end()) found = recent.insert(found, std::make_shared<MachineModes<N>>(scene));
    std::rotate(recent.begin(), found, found + 1);
    drop_oldest(recent);
    return recent.front();
  }

 private:
  template <int N>
  using Recent = std::vector<std::shared_ptr<MachineModes<N>>>;  ///< the one used last comes first

  template <int N>
  void drop_oldest(std::vector<std::shared_ptr<MachineModes<N>>>& recent) const {
    std::size_t bytes = 0, kept = 0;
    for (const auto& modes : recent) {
      bytes += modes->bytes();
      if (kept > 0 && bytes > most_bytes_) break;
      ++kept;
    }
    recent.resize(kept);
  }

  std::size_t most_bytes_;
  std::tuple<Recent<2>, Recent<4>, Recent<6>, Recent<Eigen::Dynamic>> recent_;
};

}  // namespace rubsweep::integrate::exact
