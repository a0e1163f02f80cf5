#include "machine_search/findings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "rubsweep/response/motion/motion.hpp"

namespace rubsweep::machine_search {
namespace {

using response::motion::MotionClass;

constexpr double natural_frequency_hz = 30;
constexpr double clearance_m = 1e-3;

double speed_of(const sweep::Row& row) { return row.speed_hz / natural_frequency_hz; }

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

template <class Condition>
double count(const Rows& map, Condition condition) {
  return static_cast<double>(std::count_if(map.begin(), map.end(), condition));
}

bool is_subharmonic(const sweep::Row& row) { return row.motion_class == MotionClass::subharmonic; }

/// The motion that names a domain is largest at 1/n of the shaft speed; other motions of the same period are
/// not. A stiff contact may bounce several times in one pass, so that hits do not tell.
bool in_tongue(const sweep::Row& row, int order) {
  return is_subharmonic(row) && row.order == order && row.measures && row.measures->dominant &&
         std::abs(std::abs(row.measures->dominant->order) * order - 1) < 1e-3;
}

bool is_circle(const sweep::Row& row) {
  return row.motion_class == MotionClass::synchronous && row.measures &&
         row.measures->orbit == response::spectrum::OrbitKind::circle;
}

bool is_comb(const sweep::Row& row) {
  return row.motion_class == MotionClass::quasi_periodic && row.measures &&
         row.measures->comb_spacing.has_value();
}

bool is_backward(const sweep::Row& row) {
  return row.measures && row.measures->whirl == response::spectrum::WhirlKind::backward;
}

/// Extent of one tongue, in natural frequencies and whirl ratios.
struct Tongue {
  double cells = 0, cells_at_tenth = 0;  ///< of all; at the whirl ratio 0.1
  double lowest_speed = 1e9, least_ratio = 1e9;
  double low_sum = 0, low_cells = 0, high_sum = 0, high_cells = 0;  ///< speeds below and above ratio 0.3
  std::map<double, std::pair<double, double>> rows;                 ///< first and last speed by ratio
};

Tongue tongue_of(const Rows& map, int order) {
  Tongue tongue;
  for (const sweep::Row& row : map) {
    if (!in_tongue(row, order)) continue;
    const double speed = speed_of(row);
    tongue.cells += 1;
    tongue.cells_at_tenth += std::abs(row.whirl_ratio - 0.1) < 1e-9;
    tongue.lowest_speed = std::min(tongue.lowest_speed, speed);
    tongue.least_ratio = std::min(tongue.least_ratio, row.whirl_ratio);
    const bool high = row.whirl_ratio > 0.3;
    (high ? tongue.high_sum : tongue.low_sum) += speed;
    (high ? tongue.high_cells : tongue.low_cells) += 1;
    const auto [entry, is_new] = tongue.rows.emplace(row.whirl_ratio, std::pair(speed, speed));
    if (!is_new) entry->second.second = speed;
  }
  return tongue;
}

bool leans(const Tongue& tongue) {
  return tongue.low_cells > 0 && tongue.high_cells > 0 &&
         tongue.high_sum / tongue.high_cells > tongue.low_sum / tongue.low_cells;
}

/// Whether quiet cells lie between two tongues in some row.
bool has_gap(const Rows& map, const Tongue& lower, const Tongue& upper) {
  return std::any_of(map.begin(), map.end(), [&](const sweep::Row& row) {
    const auto below = lower.rows.find(row.whirl_ratio), above = upper.rows.find(row.whirl_ratio);
    return row.motion_class == MotionClass::non_contact && below != lower.rows.end() &&
           above != upper.rows.end() && speed_of(row) > below->second.second &&
           speed_of(row) < above->second.first;
  });
}

double highest_circle(const Rows& map, std::size_t first = 0, std::size_t end = ~std::size_t{0}) {
  double top = 0;
  for (std::size_t i = first; i < std::min(end, map.size()); ++i) {
    if (is_circle(map[i])) top = std::max(top, speed_of(map[i]));
  }
  return top;
}

/// A circle inside the clearance: the casing moves against the rotor.
double small_circles(const Rows& map) {
  return count(map, [](const sweep::Row& row) {
    return is_circle(row) && row.measures->amplitude_1x_forward_m < clearance_m;
  });
}

double even_share(const Rows& map) {
  return share(count(map, [](const auto& row) { return is_subharmonic(row) && *row.order % 2 == 0; }),
               count(map, is_subharmonic));
}

std::size_t speeds_of(const Rows& map) {
  std::set<double> speeds;
  for (const sweep::Row& row : map) speeds.insert(row.speed_hz);
  return speeds.size();
}

}  // namespace

std::vector<Mark> one_side_marks(const Rows& map) {
  std::array<Tongue, 4> tongues;
  double orders = 0, leaning = 0, gaps = 0, nested = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const int n = static_cast<int>(i) + 2;
    tongues[i] = tongue_of(map, n);
    orders +=
        tongues[i].cells_at_tenth > 0 && tongues[i].lowest_speed > n && tongues[i].lowest_speed < n + 1.5;
    leaning += leans(tongues[i]);
    if (i == 0 || tongues[i].cells == 0 || tongues[i - 1].cells == 0) continue;
    gaps += has_gap(map, tongues[i - 1], tongues[i]);
    nested += tongues[i].least_ratio <= tongues[i - 1].least_ratio;
  }
  const bool strict = tongues[3].least_ratio < tongues[0].least_ratio;
  const double irregular = share(count(map,
                                       [](const auto& row) {
                                         return row.motion_class == MotionClass::chaotic ||
                                                row.motion_class == MotionClass::unsettled;
                                       }),
                                 static_cast<double>(map.size()));
  return {{"orders", orders / 4, 3},
          {"lean", leaning / 4, 1},
          {"gaps", gaps / 3, 1},
          {"nested", strict ? nested / 3 : nested / 6, 1},
          {"regular", std::max(0.0, 1 - irregular / 0.15), 1}};
}

std::vector<Mark> both_sides_marks(const Rows& map) {
  double synchronous_top = 0;
  for (const sweep::Row& row : map) {
    if (row.motion_class == MotionClass::synchronous && row.whirl_ratio > 0.3)
      synchronous_top = std::max(synchronous_top, speed_of(row));
  }
  const double subharmonic = count(map, is_subharmonic);
  const double upper =
      count(map, [](const auto& row) { return is_subharmonic(row) && row.whirl_ratio > 0.3; });
  const bool some = subharmonic >= 3;
  return {{"synchronous", std::min(1.0, synchronous_top / 5), 1},
          {"subharmonic_low", some ? 1 - share(upper, subharmonic) : 0, 1},
          {"odd", some ? std::max(0.0, 1 - even_share(map) / 0.25) : 0, 1}};
}

std::vector<Mark> unequal_casings_marks(const Rows& map) {
  return {{"even", std::min(1.0, even_share(map) / 0.2), 1}};
}

std::vector<Mark> annulus_marks(const Rows& map) {
  const double circle_top = highest_circle(map);
  double oval_least = 1e9, circle_least = 1e9, ovals = 0, whips = 0, low = 0, low_circles = 0;
  for (const sweep::Row& row : map) {
    if (speed_of(row) < 3 && row.whirl_ratio > 0.3) {
      ++low;
      low_circles += is_circle(row);
    }
    if (is_circle(row)) circle_least = std::min(circle_least, row.whirl_ratio);
    if (!is_comb(row)) continue;
    whips += is_backward(row);
    if (is_backward(row)) continue;
    ovals += speed_of(row) > std::max(2.0, circle_top);
    oval_least = std::min(oval_least, row.whirl_ratio);
  }
  return {{"circle", share(low_circles, low), 1},
          {"oval", std::min(1.0, ovals / 6), 1},
          {"oval_small", ovals > 0 && circle_top > 0 && oval_least < circle_least ? 1.0 : 0.0, 1},
          {"no_whip", 1 - share(whips, static_cast<double>(map.size())), 1}};
}

std::vector<Mark> offset_marks(const Rows& map, const Rows& centred) {
  const std::size_t speeds = speeds_of(map);
  double rows = 0, wider = 0, second = 1e9, third = 1e9;
  for (std::size_t first = 0; first < map.size(); first += speeds) {
    const double top = highest_circle(map, first, first + speeds);
    const double top_centred = highest_circle(centred, first, first + speeds);
    rows += top > 0 || top_centred > 0;
    wider += top > top_centred;
  }
  for (const sweep::Row& row : map) {
    if (!is_subharmonic(row)) continue;
    if (*row.order == 2) second = std::min(second, speed_of(row));
    if (*row.order == 3) third = std::min(third, speed_of(row));
  }
  const double slightly_above = 0.5 * (second > 2 && second < 2.5) + 0.5 * (third > 3 && third < 3.5);
  return {{"wider", share(wider, rows), 1},
          {"subharmonics", slightly_above, 1},
          {"other_circle", small_circles(map) > 0 && small_circles(centred) == 0 ? 1.0 : 0.0, 1}};
}

double sum(const std::vector<Mark>& marks) {
  double total = 0;
  for (const Mark& mark : marks) total += mark.value * mark.weight;
  return total;
}

double most(const std::vector<Mark>& marks) {
  double total = 0;
  for (const Mark& mark : marks) total += mark.weight;
  return total;
}

}  // namespace rubsweep::machine_search
