#include "rubsweep/core/response/motion/motion_class.hpp"

#include "rubsweep/core/error.hpp"

namespace rubsweep::response::motion {
namespace {

constexpr int largest_order_shown = 8;

const MotionKind& named(std::string_view name) {
  if (const MotionKind* kind = motion_kind_of(name)) return *kind;
  throw SolverError("a kind of motion without a row in its table");
}

const MotionKind& subharmonic(int order) {
  constexpr std::string_view first = "subharmonic_2";
  const auto place = std::ranges::find(motion_kinds, first, &MotionKind::name);
  return *(place + (std::clamp(order, 2, largest_order_shown) - 2));
}

}  // namespace

const MotionKind* motion_kind_of(std::string_view name) {
  const auto kind = std::ranges::find(motion_kinds, name, &MotionKind::name);
  return kind == motion_kinds.end() ? nullptr : &*kind;
}

const MotionKind& kind_of(MotionClass motion_class, std::optional<int> order,
                          std::optional<spectrum::OrbitKind> orbit, std::optional<spectrum::WhirlKind> whirl,
                          bool comb) {
  const bool backward = whirl == spectrum::WhirlKind::backward;
  if (motion_class == MotionClass::subharmonic) return subharmonic(order.value_or(2));
  if (motion_class == MotionClass::synchronous && orbit == spectrum::OrbitKind::circle)
    return named(backward ? "synchronous_circle_backward" : "synchronous_circle");
  if (motion_class == MotionClass::quasi_periodic && comb)
    return named(backward ? "quasi_periodic_whip" : "quasi_periodic_oval");
  return named(to_string(motion_class));
}

}  // namespace rubsweep::response::motion
