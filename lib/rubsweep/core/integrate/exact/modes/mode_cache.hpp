#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::exact::modes {

template <int N>
class MachineModes;

/// Largest memory of all modes of a machine in bytes, if none of them has a modal form.
std::size_t most_bytes_of_modes(Eigen::Index coordinates, std::size_t contacts);

/// Largest number of stops whose joint contact modes can be numbered.
inline constexpr std::size_t most_exact_contacts = 6;

/// Whether the exact solver and Taylor pieces support the scene: all walls flat or round without a curved
/// law, and no more stops or coordinates than their limits (which allow every configuration).
bool exact_applies(const scene::Scene& scene);

/// Default capacity of a ModeCache.
inline constexpr std::size_t most_bytes_of_a_mode_cache = std::size_t{256} << 20;

/// Least-recently-used cache of the modes of machines, so that runs of one machine with other unbalances need
/// no new factorisation. A rotor with gyroscopic forces is a different machine at each speed, and a map
/// returns to every speed once per row. Belongs to one thread. Users need not include the modes, which are
/// compiled in one source.
class ModeCache {
 public:
  /// `most_bytes`: above this size, machines that were unused for longest are dropped, except the requested
  /// one. A kit of 24 states takes about 1 MB per speed, a kit of 200 states about 100 MB.
  explicit ModeCache(std::size_t most_bytes = most_bytes_of_a_mode_cache);
  ModeCache(ModeCache&&) noexcept;
  ModeCache& operator=(ModeCache&&) noexcept;
  ~ModeCache();

  /// Modes for a scene; call it once per run.
  template <int N>
  std::shared_ptr<MachineModes<N>> modes_of(const scene::Scene& scene);

 private:
  struct Recent;

  std::unique_ptr<Recent> recent_;
};

}  // namespace rubsweep::integrate::exact::modes
