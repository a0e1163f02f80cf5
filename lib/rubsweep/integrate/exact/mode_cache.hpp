#pragma once

#include <memory>
#include <tuple>

#include "rubsweep/integrate/exact/machine_modes.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate::exact {

/// The modes of the last machines, so that runs of one machine at other speeds and unbalances need not
/// factorise again. Belongs to one thread.
class ModeCache {
 public:
  template <int N>
  std::shared_ptr<MachineModes<N>> modes_of(const scene::Scene& scene) {
    auto& last = std::get<std::shared_ptr<MachineModes<N>>>(last_);
    if (!last || !last->fits(scene)) last = std::make_shared<MachineModes<N>>(scene);
    return last;
  }

 private:
  std::tuple<std::shared_ptr<MachineModes<2>>, std::shared_ptr<MachineModes<4>>,
             std::shared_ptr<MachineModes<6>>, std::shared_ptr<MachineModes<Eigen::Dynamic>>>
      last_;
};

}  // namespace rubsweep::integrate::exact
