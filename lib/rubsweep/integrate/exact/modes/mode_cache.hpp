#pragma once

#include <cstddef>
#include <memory>
#include <tuple>

#include "rubsweep/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/numerics/recently_used.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate::exact::modes {

/// Default capacity of a ModeCache.
inline constexpr std::size_t most_bytes_of_a_mode_cache = std::size_t{256} << 20;

/// Least-recently-used cache of the modes of machines, so that runs of one machine at other unbalances need
/// not factorise again: a rotor whose gyroscopic forces grow with the speed is another machine at each speed,
/// and a map comes back to every speed once a row. Belongs to one thread.
class ModeCache {
 public:
  /// Drops the machines unused for longest until the cache holds no more than this; the machine asked for
  /// stays. A kit of 24 states takes about 1 MB a speed, one of 200 states 100.
  explicit ModeCache(std::size_t most_bytes = most_bytes_of_a_mode_cache)
      : recent_(most_bytes, most_bytes, most_bytes, most_bytes) {}

  template <int N>
  std::shared_ptr<MachineModes<N>> modes_of(const scene::Scene& scene) {
    auto& recent = std::get<Recent<N>>(recent_);
    const auto fits = [&](const auto& modes) { return modes->fits(scene); };
    if (const auto* newest = recent.newest(); newest && fits(*newest)) return *newest;
    if (!recent.find(fits)) recent.emplace(std::make_shared<MachineModes<N>>(scene));
    recent.trim([](const auto& modes) { return modes->bytes(); });
    return *recent.newest();
  }

 private:
  template <int N>
  using Recent = numerics::RecentlyUsed<std::shared_ptr<MachineModes<N>>>;

  std::tuple<Recent<2>, Recent<4>, Recent<6>, Recent<Eigen::Dynamic>> recent_;
};

}  // namespace rubsweep::integrate::exact::modes
