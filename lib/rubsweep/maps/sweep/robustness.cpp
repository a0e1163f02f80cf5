#include "rubsweep/maps/sweep/robustness.hpp"

namespace rubsweep::sweep {
namespace {

bool has_kicked_motion(const Row& row, const model::Machine& machine) {
  using response::motion::MotionClass;
  return machine.kick && row.start != RunStart::contact && row.motion_class != MotionClass::initial_contact &&
         row.motion_class != MotionClass::failed;
}

bool keeps_motion(const Row& row, const model::Machine& machine, double factor,
                  const std::function<Row(const model::Machine&)>& evaluate) {
  const Row other = evaluate(model::with_kick_force(machine, machine.kick->force_n * factor));
  return other.motion_class == row.motion_class && other.order == row.order;
}

}  // namespace

std::optional<bool> is_robust(const Row& row, const model::Machine& machine,
                              const std::function<Row(const model::Machine&)>& evaluate) {
  if (!has_kicked_motion(row, machine)) return std::nullopt;
  for (const double factor : {1 - robustness_change, 1 + robustness_change}) {
    if (!keeps_motion(row, machine, factor, evaluate)) return false;
  }
  return true;
}

std::optional<double> robust_share(const Row& row, const model::Machine& machine,
                                   const Neighbours& neighbours,
                                   const std::function<Row(const model::Machine&)>& evaluate) {
  if (!has_kicked_motion(row, machine)) return std::nullopt;
  const int half = neighbours.count / 2;
  int kept = 0;
  for (int i = -half; i <= half; ++i) {
    if (i != 0 && keeps_motion(row, machine, 1 + neighbours.part * i / half, evaluate)) ++kept;
  }
  return static_cast<double>(kept) / (2 * half);
}

}  // namespace rubsweep::sweep
