#include "rubsweep/sweep/robustness.hpp"

namespace rubsweep::sweep {

std::optional<bool> is_robust(const Row& row, const model::Machine& machine,
                              const std::function<Row(const model::Machine&)>& evaluate) {
  using response::motion::MotionClass;
  if (!machine.kick || row.start == RunStart::contact || row.motion_class == MotionClass::initial_contact ||
      row.motion_class == MotionClass::failed) {
    return std::nullopt;
  }
  model::Machine changed = machine;
  for (const double factor : {1 - robustness_change, 1 + robustness_change}) {
    changed.kick->force_n = machine.kick->force_n * factor;
    const Row other = evaluate(changed);
    if (other.motion_class != row.motion_class || other.order != row.order) return false;
  }
  return true;
}

}  // namespace rubsweep::sweep
