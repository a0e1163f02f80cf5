#include "campbell_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/response/spectrum/orbit_shape.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {
namespace {

using batch::csv_number;

std::string_view whirl_of(double forward_share) {
  return to_string(response::spectrum::whirl_kind(forward_share, 1 - forward_share));
}

std::string campbell_csv(const std::vector<linear::CampbellMode>& modes) {
  std::string text = "speed_hz,mode,whirl,forward_share,frequency_hz,damping_ratio\n";
  for (const linear::CampbellMode& mode : modes) {
    for (const linear::CampbellPoint& point : mode.points) {
      text += fmt::format("{},{},{},{},{},{}\n", csv_number(point.speed_hz), mode.number,
                          whirl_of(point.forward_share), csv_number(point.forward_share),
                          csv_number(point.frequency_hz), csv_number(point.damping_ratio));
    }
  }
  return text;
}

std::string critical_speeds_csv(const std::vector<linear::CriticalSpeed>& speeds) {
  std::string text = "mode,whirl,speed_hz,damping_ratio\n";
  for (const linear::CriticalSpeed& critical : speeds) {
    text += fmt::format("{},{},{},{}\n", critical.mode, whirl_of(critical.forward_share),
                        csv_number(critical.speed_hz), csv_number(critical.damping_ratio));
  }
  return text;
}

std::string mode_shapes_csv(const linear::Campbell& diagram) {
  std::string text = "mode,whirl,speed_hz,frequency_hz,position_m,x_real,x_imag,y_real,y_imag\n";
  for (const linear::ModeShape& shape : diagram.shapes) {
    for (std::size_t i = 0; i < diagram.position_m.size(); ++i) {
      const auto x = shape.x(static_cast<Eigen::Index>(i)), y = shape.y(static_cast<Eigen::Index>(i));
      text += fmt::format("{},{},{},{},{},{},{},{},{}\n", shape.mode, whirl_of(shape.forward_share),
                          csv_number(shape.speed_hz), csv_number(shape.frequency_hz),
                          csv_number(diagram.position_m[i]), csv_number(x.real()), csv_number(x.imag()),
                          csv_number(y.real()), csv_number(y.imag()));
    }
  }
  return text;
}

std::string summary_of(const linear::Campbell& diagram, const std::vector<linear::LockSpeed>& locks) {
  std::string text;
  for (const linear::CampbellMode& mode : diagram.modes) {
    if (mode.points.empty()) continue;  // a mode may whirl only between two neighbouring speeds
    const linear::CampbellPoint &first = mode.points.front(), &last = mode.points.back();
    text += fmt::format("mode {:<4} {:.5g} Hz at {}, {:.5g} Hz at {} ({})", mode.number, first.frequency_hz,
                        model::speed_text(first.speed_hz, 5), last.frequency_hz,
                        model::speed_text(last.speed_hz, 5), whirl_of(last.forward_share));
    const bool unstable = std::ranges::any_of(mode.points, [](const auto& p) { return p.damping_ratio < 0; });
    text += unstable ? ", unstable at some speeds\n" : "\n";
  }
  linear::GrowthAt worst;
  for (const linear::GrowthAt& one : diagram.growth)
    if (one.growth_per_s > worst.growth_per_s) worst = one;
  if (worst.growth_per_s > 0)
    text += fmt::format("unstable  a free vibration grows by up to {:.4g} 1/s, at {}\n", worst.growth_per_s,
                        model::speed_text(worst.speed_hz));
  for (const linear::CriticalSpeed& critical : diagram.critical_speeds) {
    text +=
        fmt::format("critical  {}, mode {}, {}, damping ratio {:.4g}\n", model::speed_text(critical.speed_hz),
                    critical.mode, whirl_of(critical.forward_share), critical.damping_ratio);
  }
  if (diagram.critical_speeds.empty()) text += "critical  none in this range of speeds\n";
  for (const linear::LockSpeed& lock : locks) {
    text += fmt::format("lock      {}, {} turns of mode {} to {} of mode {} in the turning frame\n",
                        model::speed_text(lock.speed_hz), lock.p, lock.first, lock.q, lock.second);
  }
  return text;
}

}  // namespace

std::string lock_speeds_csv(const std::vector<linear::LockSpeed>& speeds) {
  std::string text = "speed_hz,p,first_mode,q,second_mode\n";
  for (const linear::LockSpeed& lock : speeds)
    text +=
        fmt::format("{},{},{},{},{}\n", csv_number(lock.speed_hz), lock.p, lock.first, lock.q, lock.second);
  return text;
}

CampbellTables tables_of(const linear::Campbell& diagram) {
  const std::vector<linear::LockSpeed> locks = linear::lock_speeds(diagram);
  return {.campbell_csv = campbell_csv(diagram.modes),
          .critical_speeds_csv = critical_speeds_csv(diagram.critical_speeds),
          .mode_shapes_csv = mode_shapes_csv(diagram),
          .lock_speeds_csv = lock_speeds_csv(locks),
          .summary = summary_of(diagram, locks)};
}

}  // namespace rubsweep::apps
