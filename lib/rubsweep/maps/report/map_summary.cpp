#include "rubsweep/maps/report/map_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/maps/report/map_csv.hpp"

namespace rubsweep::report {
namespace {

using response::motion::MotionClass;

/// Text of a column of a line. None of the columns used here is ever quoted.
std::string_view cell(std::string_view line, std::size_t column) {
  for (; column > 0; --column) line.remove_prefix(line.find(',') + 1);
  return line.substr(0, line.find(','));
}

/// Number in a cell; 0 where there is none.
double number_in(std::string_view cell) {
  double value = 0;
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

/// Name of a motion from `name`, class and order; the kind is added where the class has several kinds.
std::string name_of(std::string name, std::string_view motion_class, bool circle, bool comb,
                    std::string_view whirl) {
  if (motion_class == to_string(MotionClass::synchronous) && circle)
    name += fmt::format(" circle, {}", whirl);
  if (motion_class == to_string(MotionClass::quasi_periodic) && comb)
    name += whirl == "backward" ? " dry whip, backward" : fmt::format(" oval, {}", whirl);
  return name;
}

}  // namespace

std::string motion_name(const sweep::Row& row) {
  if (!row.measures) return sweep::class_and_order(row);
  const auto& measures = *row.measures;
  return name_of(sweep::class_and_order(row), to_string(row.motion_class),
                 measures.orbit == response::spectrum::OrbitKind::circle, measures.comb_spacing.has_value(),
                 measures.whirl ? to_string(*measures.whirl) : "");
}

std::string motion_name(std::string_view map_line) {
  static const std::size_t class_column = place_of_column("class"), order_column = place_of_column("order"),
                           orbit_column = place_of_column("orbit"), whirl_column = place_of_column("whirl"),
                           comb_column = place_of_column("comb_spacing");
  const std::string_view word = cell(map_line, class_column), order = cell(map_line, order_column);
  return name_of(order.empty() || order == "1" ? std::string(word) : fmt::format("{} 1/{}", word, order),
                 word, cell(map_line, orbit_column) == "circle", !cell(map_line, comb_column).empty(),
                 cell(map_line, whirl_column));
}

const response::motion::MotionKind& kind_in(std::string_view map_line) {
  static const std::size_t column = place_of_column("kind");
  if (const auto* kind = response::motion::motion_kind_of(cell(map_line, column))) return *kind;
  throw IoError(fmt::format("map.csv: '{}' is no kind of motion", cell(map_line, column)));
}

std::string label_of(std::string_view map_line) {
  static const std::size_t class_column = place_of_column("class"), order_column = place_of_column("order");
  return fmt::format("{},{}", cell(map_line, class_column), cell(map_line, order_column));
}

void MapSummary::add(std::string_view map_line) {
  static const std::size_t class_column = place_of_column("class"), status_column = place_of_column("status"),
                           start_column = place_of_column("start"),
                           last_column = place_of_column("last_contact_revolution"),
                           peak_column = place_of_column("peak_over_clearance");
  ++total_;
  ++by_name_[motion_name(map_line)];
  const std::string_view status = cell(map_line, status_column);
  if (status != "ok") ++by_status_[std::string(status)];
  if (cell(map_line, class_column) == to_string(MotionClass::non_contact)) ++non_contact_;
  if (cell(map_line, start_column) == to_string(sweep::RunStart::kick)) ++kicked_;
  if (cell(map_line, start_column) == to_string(sweep::RunStart::state)) ++stated_;
  if (!cell(map_line, last_column).empty()) ++touched_;
  const double peak = number_in(cell(map_line, peak_column));
  largest_over_clearance_ = std::max(largest_over_clearance_, peak);
  if (peak > warn_over_clearances_) ++far_;
}

bool MapSummary::has_failed_cells() const {
  return by_name_.contains(std::string(to_string(MotionClass::failed)));
}

std::string MapSummary::text() const {
  std::vector<std::pair<std::string, std::size_t>> sorted(by_name_.begin(), by_name_.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (const auto& [name, count] : sorted) {
    const double percent = 100.0 * static_cast<double>(count) / static_cast<double>(total_);
    text += fmt::format("{:>8}  {:5.1f} %  {}\n", count, percent, name);
  }
  for (const auto& [status, count] : by_status_) text += fmt::format("{:>8}  status {}\n", count, status);
  if (far_ > 0) {
    text += fmt::format("{:>8}  move farther than {} clearances, at most {:.3g}\n", far_,
                        warn_over_clearances_, largest_over_clearance_);
  }
  return text + why_all_is_quiet();
}

std::string MapSummary::warning() const {
  if (far_ == 0) return "";
  return fmt::format(
      "warning: in {} of {} cells the rotor moves farther than {} clearances, at most {:.3g}; hardly a shaft "
      "is linear up to there (column peak_over_clearance, key output.warn_over_clearances)\n{}",
      far_, total_, warn_over_clearances_, largest_over_clearance_, unbalance_question());
}

std::string MapSummary::unbalance_question() const {
  constexpr double no_motion_of_a_rotor = 100;
  if (largest_over_clearance_ <= no_motion_of_a_rotor) return "";
  return fmt::format(
      "question: what was the unbalance meant to be? It moves the rotor by {:.3g} clearances (an "
      "eccentricity in millimetres, a whirl ratio in per cent, an unbalance in g cm?)\n",
      largest_over_clearance_);
}

std::string MapSummary::why_all_is_quiet() const {
  if (total_ == 0 || non_contact_ != total_) return "";
  if (stated_ > 0) {
    return touched_ == 0
               ? "no wall was ever touched: no start (start.x_m, start.vx_m_per_s, ...) leads to one\n"
               : "nothing rubs on: the rotor reached a wall, but came free of it everywhere\n";
  }
  if (kicked_ == 0) return "no wall was ever touched: there is no kick (kick.force_n, kick.duration_s)\n";
  if (touched_ == 0) {
    return "no wall was ever touched: the kick is too weak to reach one (kick.force_n, or larger whirl "
           "ratios)\n";
  }
  return "nothing rubs on: the kick reached a wall, but the rotor came free of it everywhere\n";
}

}  // namespace rubsweep::report
