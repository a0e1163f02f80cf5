#include "rubsweep/analysis/linear/campbell_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/numerics/pchip.hpp"
#include "rubsweep/core/response/spectrum/orbit_shape.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::linear {
namespace {

constexpr std::size_t most_modes = 4;
constexpr std::array<std::pair<int, int>, 3> orders{{{2, 1}, {3, 1}, {3, 2}}};
constexpr int halvings = 60;
/// a mode with more damping has decayed before both modes meet the wall again
constexpr double most_damping_ratio = 0.5;

double signed_hz(const CampbellPoint& point) {
  return point.forward_share >= 0.5 ? point.frequency_hz : -point.frequency_hz;
}

bool lasts_somewhere(const CampbellMode& mode) {
  return std::ranges::any_of(
      mode.points, [](const CampbellPoint& point) { return point.damping_ratio <= most_damping_ratio; });
}

/// Mode as a function of the speed.
struct Branch {
  int number = 0;
  std::vector<double> speed_hz;
  std::vector<double> damping_ratio;
  numerics::Pchip signed_hz;

  bool lasts_at(std::size_t k) const { return damping_ratio[k] <= most_damping_ratio; }
  /// Whether the mode is lightly damped and keeps its sense of whirl over the interval that ends at point k.
  bool lasts_up_to(std::size_t k) const {
    return lasts_at(k - 1) && lasts_at(k) && signed_hz(speed_hz[k - 1]) * signed_hz(speed_hz[k]) > 0;
  }
};

Branch branch_of(const CampbellMode& mode) {
  std::vector<double> speeds, frequencies, ratios;
  for (const CampbellPoint& point : mode.points) {
    speeds.push_back(point.speed_hz);
    frequencies.push_back(signed_hz(point));
    ratios.push_back(point.damping_ratio);
  }
  return {mode.number, speeds, ratios, numerics::Pchip(speeds, frequencies)};
}

/// Index of a speed in a branch; empty where the mode does not whirl at this speed.
std::optional<std::size_t> place_of(const Branch& branch, double speed_hz) {
  const auto found = std::ranges::lower_bound(branch.speed_hz, speed_hz);
  if (found == branch.speed_hz.end() || *found != speed_hz) return std::nullopt;
  return static_cast<std::size_t>(found - branch.speed_hz.begin());
}

/// Adds the speeds at which two modes lock: at most one root in each interval of the diagram that both modes
/// have.
void add_roots(const Branch& first, const Branch& second, int p, int q, std::vector<LockSpeed>& found) {
  const auto excess = [&](double hz) {
    return (p - q) * hz - p * first.signed_hz(hz) + q * second.signed_hz(hz);
  };
  for (std::size_t k = 0; k < first.speed_hz.size(); ++k) {
    const double end = first.speed_hz[k];
    const auto place = place_of(second, end);
    if (!place || !first.lasts_at(k) || !second.lasts_at(*place)) continue;
    if (excess(end) == 0 && end > 0) found.push_back({first.number, second.number, p, q, end});
    if (k == 0 || *place == 0 || second.speed_hz[*place - 1] != first.speed_hz[k - 1]) continue;
    if (!first.lasts_up_to(k) || !second.lasts_up_to(*place)) continue;
    if (!(excess(first.speed_hz[k - 1]) * excess(end) < 0)) continue;
    double low = first.speed_hz[k - 1], high = end;
    for (int i = 0; i < halvings; ++i) {
      const double middle = low + (high - low) / 2;
      (excess(middle) * excess(end) < 0 ? low : high) = middle;
    }
    found.push_back({first.number, second.number, p, q, high});
  }
}

using batch::csv_number;

std::string_view whirl_of(double forward_share) {
  return to_string(response::spectrum::whirl_kind(forward_share, 1 - forward_share));
}

std::string campbell_csv(const std::vector<CampbellMode>& modes) {
  std::string text = "speed_hz,mode,whirl,forward_share,frequency_hz,damping_ratio\n";
  for (const CampbellMode& mode : modes) {
    for (const CampbellPoint& point : mode.points) {
      text += fmt::format("{},{},{},{},{},{}\n", csv_number(point.speed_hz), mode.number,
                          whirl_of(point.forward_share), csv_number(point.forward_share),
                          csv_number(point.frequency_hz), csv_number(point.damping_ratio));
    }
  }
  return text;
}

std::string critical_speeds_csv(const std::vector<CriticalSpeed>& speeds) {
  std::string text = "mode,whirl,speed_hz,damping_ratio\n";
  for (const CriticalSpeed& critical : speeds) {
    text += fmt::format("{},{},{},{}\n", critical.mode, whirl_of(critical.forward_share),
                        csv_number(critical.speed_hz), csv_number(critical.damping_ratio));
  }
  return text;
}

std::string mode_shapes_csv(const Campbell& diagram) {
  std::string text = "mode,whirl,speed_hz,frequency_hz,position_m,x_real,x_imag,y_real,y_imag\n";
  for (const ModeShape& shape : diagram.shapes) {
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

std::string summary_of(const Campbell& diagram, const std::vector<LockSpeed>& locks) {
  std::string text;
  for (const CampbellMode& mode : diagram.modes) {
    if (mode.points.empty()) continue;  // a mode may whirl only between two neighbouring speeds
    const CampbellPoint &first = mode.points.front(), &last = mode.points.back();
    text += fmt::format("mode {:<4} {:.5g} Hz at {}, {:.5g} Hz at {} ({})", mode.number, first.frequency_hz,
                        model::speed_text(first.speed_hz, 5), last.frequency_hz,
                        model::speed_text(last.speed_hz, 5), whirl_of(last.forward_share));
    const bool unstable = std::ranges::any_of(mode.points, [](const auto& p) { return p.damping_ratio < 0; });
    text += unstable ? ", unstable at some speeds\n" : "\n";
  }
  GrowthAt worst;
  for (const GrowthAt& one : diagram.growth)
    if (one.growth_per_s > worst.growth_per_s) worst = one;
  if (worst.growth_per_s > 0)
    text += fmt::format("unstable  a free vibration grows by up to {:.4g} 1/s, at {}\n", worst.growth_per_s,
                        model::speed_text(worst.speed_hz));
  for (const CriticalSpeed& critical : diagram.critical_speeds) {
    text +=
        fmt::format("critical  {}, mode {}, {}, damping ratio {:.4g}\n", model::speed_text(critical.speed_hz),
                    critical.mode, whirl_of(critical.forward_share), critical.damping_ratio);
  }
  if (diagram.critical_speeds.empty()) text += "critical  none in this range of speeds\n";
  for (const LockSpeed& lock : locks) {
    text += fmt::format("lock      {}, {} turns of mode {} to {} of mode {} in the turning frame\n",
                        model::speed_text(lock.speed_hz), lock.p, lock.first, lock.q, lock.second);
  }
  return text;
}

}  // namespace

std::vector<LockSpeed> lock_speeds(const Campbell& diagram) {
  std::vector<Branch> branches;
  for (const CampbellMode& mode : diagram.modes)
    if (branches.size() < most_modes && lasts_somewhere(mode)) branches.push_back(branch_of(mode));
  std::vector<LockSpeed> found;
  for (const Branch& first : branches) {
    for (const Branch& second : branches) {
      if (first.number == second.number) continue;
      for (const auto& [p, q] : orders) add_roots(first, second, p, q, found);
    }
  }
  std::ranges::stable_sort(found, {}, &LockSpeed::speed_hz);
  return found;
}

std::string lock_speeds_csv(const std::vector<LockSpeed>& speeds) {
  std::string text = "speed_hz,p,first_mode,q,second_mode\n";
  for (const LockSpeed& lock : speeds)
    text +=
        fmt::format("{},{},{},{},{}\n", csv_number(lock.speed_hz), lock.p, lock.first, lock.q, lock.second);
  return text;
}

CampbellTables tables_of(const Campbell& diagram) {
  const std::vector<LockSpeed> locks = lock_speeds(diagram);
  return {.campbell_csv = campbell_csv(diagram.modes),
          .critical_speeds_csv = critical_speeds_csv(diagram.critical_speeds),
          .mode_shapes_csv = mode_shapes_csv(diagram),
          .lock_speeds_csv = lock_speeds_csv(locks),
          .summary = summary_of(diagram, locks)};
}

}  // namespace rubsweep::linear
