#include "rubsweep/maps/sweep/row.hpp"

#include <fmt/format.h>

namespace rubsweep::sweep {

std::string class_and_order(const Row& row) {
  const std::string_view word = to_string(row.motion_class);
  return row.order.value_or(1) > 1 ? fmt::format("{} 1/{}", word, *row.order) : std::string(word);
}

const response::motion::MotionKind& kind_of(const Row& row) {
  if (!row.measures) return response::motion::kind_of(row.motion_class, row.order, {}, {}, false);
  return response::motion::kind_of(row.motion_class, row.order, row.measures->orbit, row.measures->whirl,
                                   row.measures->comb_spacing.has_value());
}

void add_status(Row& row, std::string_view word) {
  if (row.status == "ok") {
    row.status = word;
  } else if (row.status.find(word) == std::string::npos) {
    row.status.append(";").append(word);
  }
}

SampledMotion sampled_motion(const Row& row) {
  const auto kind = response::motion::row_of(row.motion_class);
  SampledMotion motion{class_and_order(row), !row.measures, kind.rubs, kind.repeats, {}};
  if (!row.measures) return motion;
  const response::motion::Measures& measures = *row.measures;
  motion.orbit_m = {measures.contact.peak_displacement_m, measures.amplitude_1x_forward_m,
                    measures.amplitude_1x_backward_m};
  return motion;
}

}  // namespace rubsweep::sweep
