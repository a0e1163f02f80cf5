#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::exact::modes {

template <int N>
class MachineModes;

/// Largest size of the flows of all modes of a machine, taken where none of them has a modal form.
std::size_t most_bytes_of_modes(Eigen::Index coordinates, std::size_t contacts);

/// Stops whose joint contact modes can be numbered.
inline constexpr std::size_t most_exact_contacts = 6;

/// Whether the exact solver and Taylor pieces know the scene: walls that are flat or round, none with a
/// curved law, not more stops than joint modes are numbered for, nor more coordinates than a mode holds (all
/// that a configuration can ask for).
bool exact_applies(const scene::Scene& scene);

/// Default capacity of a ModeCache.
inline constexpr std::size_t most_bytes_of_a_mode_cache = std::size_t{256} << 20;

/// Least-recently-used cache of the modes of machines, so that runs of one machine at other unbalances need
/// not factorise again: a rotor whose gyroscopic forces grow with the speed is another machine at each speed,
/// and a map comes back to every speed once a row. Belongs to one thread. Whoever keeps one need not know the
/// modes, which are made in one source.
class ModeCache {
 public:
  /// Drops the machines unused for longest until the cache holds no more than this; the machine asked for
  /// stays. A kit of 24 states takes about 1 MB a speed, one of 200 states 100.
  explicit ModeCache(std::size_t most_bytes = most_bytes_of_a_mode_cache);
  ModeCache(ModeCache&&) noexcept;
  ModeCache& operator=(ModeCache&&) noexcept;
  ~ModeCache();

  /// Asked once a run.
  template <int N>
  std::shared_ptr<MachineModes<N>> modes_of(const scene::Scene& scene);

 private:
  struct Recent;

  std::unique_ptr<Recent> recent_;
};

}  // namespace rubsweep::integrate::exact::modes
