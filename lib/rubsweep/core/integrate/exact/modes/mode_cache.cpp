#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"

#include <tuple>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/numerics/recently_used.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

template <int N>
using RecentModes = numerics::RecentlyUsed<std::shared_ptr<MachineModes<N>>>;

}  // namespace

struct ModeCache::Recent {
  std::tuple<RecentModes<2>, RecentModes<4>, RecentModes<6>, RecentModes<Eigen::Dynamic>> of_size;
};

ModeCache::ModeCache(std::size_t most_bytes)
    : recent_(new Recent{{RecentModes<2>(most_bytes), RecentModes<4>(most_bytes), RecentModes<6>(most_bytes),
                          RecentModes<Eigen::Dynamic>(most_bytes)}}) {}

ModeCache::ModeCache(ModeCache&&) noexcept = default;
ModeCache& ModeCache::operator=(ModeCache&&) noexcept = default;
ModeCache::~ModeCache() = default;

template <int N>
std::shared_ptr<MachineModes<N>> ModeCache::modes_of(const scene::Scene& scene) {
  auto& recent = std::get<RecentModes<N>>(recent_->of_size);
  const auto fits = [&](const auto& modes) { return modes->fits(scene); };
  if (const auto* newest = recent.newest(); newest && fits(*newest)) return *newest;
  if (!recent.find(fits)) recent.emplace(std::make_shared<MachineModes<N>>(scene));
  recent.trim([](const auto& modes) { return modes->bytes(); });
  return *recent.newest();
}

template std::shared_ptr<MachineModes<2>> ModeCache::modes_of(const scene::Scene& scene);
template std::shared_ptr<MachineModes<4>> ModeCache::modes_of(const scene::Scene& scene);
template std::shared_ptr<MachineModes<6>> ModeCache::modes_of(const scene::Scene& scene);
template std::shared_ptr<MachineModes<Eigen::Dynamic>> ModeCache::modes_of(const scene::Scene& scene);

}  // namespace rubsweep::integrate::exact::modes
