#include "machine_search/findings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rubsweep/core/response/motion/motion.hpp"

namespace rubsweep::machine_search {
namespace {

using response::motion::MotionClass;
using response::spectrum::OrbitKind;

constexpr double area_share_seen = 1.0 / 150;
constexpr double column = 0.1, eye = 0.01;
constexpr int largest_order = 7;

bool is_subharmonic(const sweep::Row& row) { return row.motion_class == MotionClass::subharmonic; }
bool is_synchronous(const sweep::Row& row) { return row.motion_class == MotionClass::synchronous; }
bool is_even(const sweep::Row& row) { return is_subharmonic(row) && *row.order % 2 == 0; }
bool is_one_of_n(const sweep::Row& row) { return is_subharmonic(row) && *row.order <= largest_order; }
bool is_quasi_periodic(const sweep::Row& row) { return row.motion_class == MotionClass::quasi_periodic; }

bool rubs(const sweep::Row& row) {
  return is_synchronous(row) || is_subharmonic(row) || is_quasi_periodic(row) ||
         row.motion_class == MotionClass::resting_contact || row.motion_class == MotionClass::chaotic ||
         row.motion_class == MotionClass::unsettled;
}

bool any(const sweep::Row&) { return true; }

Condition has_order(int n) {
  return [n](const sweep::Row& row) { return is_subharmonic(row) && row.order == n; };
}

bool is_circle(const sweep::Row& row) {
  if (!is_synchronous(row) || !row.measures) return false;
  const auto& measures = *row.measures;
  const bool pressed =
      measures.contact.contact_fraction > 0.999 && measures.dominant && measures.dominant->order == 1;
  return (measures.orbit != OrbitKind::complex || pressed) &&
         measures.amplitude_1x_backward_m <= 0.1 * measures.amplitude_1x_forward_m;
}

bool is_oval(const sweep::Row& row) {
  return is_quasi_periodic(row) && row.measures && row.measures->comb_spacing.has_value();
}

double hits_per_revolution(const sweep::Row& row) {
  return static_cast<double>(row.measures->contact.hits) / row.measures->turns;
}

/// Impacts of an oval per revolution about the centre; see scripts/analysis/domain_measures.py.
double hits_per_whirl(const sweep::Row& row) {
  if (!row.measures->dominant) return 0;
  const double own = 1 - *row.measures->comb_spacing, order = row.measures->dominant->order;
  const bool near = std::abs(order - 1) < 1.0 / 64 || std::abs(order - own) < 1.0 / 64;
  return hits_per_revolution(row) / std::abs(near ? own : order);
}

Mark of_share(std::string_view finding, std::optional<double> share, double holds = 0.9,
              double partly = 0.5) {
  if (!share) return {finding, 0, 0};
  return {finding, *share >= holds ? 1 : *share >= partly ? 0.5 : 0, *share};
}

Mark of_both(std::string_view finding, bool first, bool second, double nearness) {
  return {finding, 0.5 * first + 0.5 * second, nearness};
}

Mark nothing_else(std::string_view finding, const Domains& domains, const Condition& named) {
  return of_share(finding, domains.share(named, rubs));
}

Mark above(const Domains& domains, std::string_view finding, int n) {
  const auto high = domains.share([n](const sweep::Row& row) { return speed_of(row) > n; }, has_order(n));
  Mark mark = of_share(finding, high);
  const bool seen = domains.area(has_order(n)) > area_share_seen * domains.area(any);
  if (!seen) mark.verdict = mark.verdict == 1 ? 0.5 : 0;
  return mark;
}

Mark leaning(const Domains& domains, std::string_view finding, int n) {
  const auto lean = domains.lean(has_order(n));
  if (!lean) return {finding, 0, 0};
  return {finding, *lean >= column ? 1 : *lean > 0 ? 0.5 : 0, std::clamp(*lean, 0.0, 1.0)};
}

Mark unbalance_of_orders(const Domains& domains) {
  std::array<double, 4> feet{};
  for (int n = 2; n <= 5; ++n) {
    const auto foot = domains.least_ratio(has_order(n));
    if (!foot) return {"nested", 0, 0};
    feet[static_cast<std::size_t>(n - 2)] = *foot;
  }
  double falls = 0, rise = -1;
  for (std::size_t i = 1; i < feet.size(); ++i) {
    falls += feet[i] < feet[i - 1];
    rise = std::max(rise, feet[i] - feet[i - 1]);
  }
  const bool partly = feet.back() < feet.front() && rise <= eye * (1 + 1e-9);
  return {"nested", falls == 3 ? 1 : partly ? 0.5 : 0, falls / 3};
}

Mark motions_of_figure_7(const Domains& domains) {
  double shown = 0;
  for (int n = 2; n <= 4; ++n) {
    shown += domains.area([&](const sweep::Row& row) {
      return has_order(n)(row) && row.whirl_ratio >= 0.08 && row.whirl_ratio <= 0.125;
    }) > 0;
  }
  return of_share("figure_7", shown / 3, 1, 0.6);
}

double gaps(const Domains& domains) {
  double least = 1;
  for (int n = 2; n <= 4; ++n) least = std::min(least, domains.parted_share(n).value_or(0));
  return least;
}

Condition within(double clearances) {
  return [clearances](const sweep::Row& row) { return row.peak_over_clearance.value_or(0) <= clearances; };
}

}  // namespace

std::vector<Mark> one_side_marks(const Rows& map) {
  const Domains domains(map);
  Mark near = of_share("near", domains.share(within(5), rubs), 0.8);
  if (domains.share(within(10), rubs).value_or(0) < 0.95) near.verdict = 0;
  return {above(domains, "2_above", 2),
          above(domains, "3_above", 3),
          above(domains, "4_above", 4),
          above(domains, "5_above", 5),
          leaning(domains, "2_leans", 2),
          leaning(domains, "3_leans", 3),
          leaning(domains, "4_leans", 4),
          leaning(domains, "5_leans", 5),
          unbalance_of_orders(domains),
          motions_of_figure_7(domains),
          of_share("gaps", gaps(domains)),
          nothing_else("one_only", domains,
                       [](const sweep::Row& row) { return is_synchronous(row) || is_one_of_n(row); }),
          near};
}

std::vector<Mark> both_sides_marks(const Rows& map) {
  const Domains domains(map);
  const double large = domains.mean_width(is_synchronous, 0.5, 2).value_or(0);
  const double small = domains.mean_width(is_synchronous, 0, 0.25).value_or(0);
  const bool third = domains.area(has_order(3)) > 0;
  const double even = domains.share(is_even, is_subharmonic).value_or(1);
  Mark odd{"odd", !third || even > 0.1 ? 0 : even <= 0.02 ? 1 : 0.5, 1 - even};
  return {
      of_both("synchronous", large > 1, large > small, std::min(1.0, large / 5)),
      of_share("subharmonic_low",
               domains.share([](const sweep::Row& row) { return row.whirl_ratio <= 0.5; }, is_subharmonic)),
      odd, nothing_else("two_only", domains, [](const sweep::Row& row) {
        return is_synchronous(row) || is_one_of_n(row);
      })};
}

std::vector<Mark> unequal_casings_marks(const Rows& map, const Rows& equal) {
  const Domains domains(map);
  const double even = domains.share(is_even, is_subharmonic).value_or(0);
  const double before = Domains(equal).share(is_even, is_subharmonic).value_or(0);
  const bool one_hit = std::any_of(map.begin(), map.end(), [](const sweep::Row& row) {
    return is_even(row) && row.measures && hits_per_revolution(row) * *row.order < 1.5;
  });
  return {{"even",
           even > 0.1 && even > 2 * before ? 1
           : even > before                 ? 0.5
                                           : 0,
           std::min(1.0, even)},
          {"one_sided", one_hit ? 1.0 : 0.0, one_hit ? 1.0 : 0.0}};
}

std::vector<Mark> annulus_marks(const Rows& map) {
  const Domains domains(map);
  const auto ovals = domains.median_speed(is_oval), circles = domains.median_speed(is_circle);
  const double middle = ovals ? *ovals : domains.median_speed(any).value_or(0);
  const auto oval_foot = domains.least_ratio(is_oval), circle_foot = domains.least_ratio(is_circle);
  const bool smaller = oval_foot && (!circle_foot || *oval_foot < *circle_foot);
  const bool high = ovals && (!circles || *ovals > *circles);
  return {of_share("circle_low",
                   domains.share([&](const sweep::Row& row) { return speed_of(row) <= middle; }, is_circle)),
          {"oval_high", high ? 0.5 : 0, high ? 0.5 : 0},
          {"oval_small", smaller ? 1.0 : 0.0, smaller ? 1.0 : 0.0},
          of_share("oval_hits",
                   domains.share([](const sweep::Row& row) { return hits_per_whirl(row) > 1.5; }, is_oval)),
          nothing_else("annulus_only", domains,
                       [](const sweep::Row& row) { return is_synchronous(row) || is_quasi_periodic(row); })};
}

std::vector<Mark> offset_marks(const Rows& map, const Rows& centred) {
  const Domains domains(map), other(centred);
  const auto tops = domains.row_tops(is_circle), other_tops = other.row_tops(is_circle);
  double rows = 0, higher = 0, gain = 0, ratio_centred = -1;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (centred[i].whirl_ratio == ratio_centred) continue;
    ratio_centred = centred[i].whirl_ratio;
    const auto top = tops.find(map[i].whirl_ratio), top_centred = other_tops.find(ratio_centred);
    if (top == tops.end() && top_centred == other_tops.end()) continue;
    const double difference = (top == tops.end() ? other.lowest_speed() : top->second) -
                              (top_centred == other_tops.end() ? other.lowest_speed() : top_centred->second);
    ++rows;
    gain += difference;
    higher += difference > 1e-9;
  }
  const Condition low_orders = [](const sweep::Row& row) { return is_subharmonic(row) && *row.order <= 5; };
  const Condition slightly = [&](const sweep::Row& row) {
    return low_orders(row) && speed_of(row) > *row.order && speed_of(row) < *row.order + 0.5;
  };
  Mark multiples = of_share("above_n", domains.share(slightly, low_orders));
  if (std::count_if(map.begin(), map.end(), slightly) < 2) multiples.verdict = 0;
  return {of_both("wider", rows > 0 && gain >= rows * domains.column() / 2, rows > 0 && higher >= rows / 2,
                  rows > 0 ? higher / rows : 0),
          multiples, nothing_else("offset_only", domains, [](const sweep::Row& row) {
            return is_synchronous(row) || is_one_of_n(row) || is_quasi_periodic(row);
          })};
}

std::vector<Mark> plausible_marks(const Candidate& candidate, const std::vector<const Rows*>& maps) {
  const bool near = std::all_of(maps.begin(), maps.end(), [](const Rows* map) {
    return std::all_of(map->begin(), map->end(),
                       [](const sweep::Row& row) { return !rubs(row) || within(10)(row); });
  });
  const bool soft = candidate.contact_stiffness_n_per_m <= 1e7;
  return {{"ten_clearances", near ? 1.0 : 0.0, near ? 1.0 : 0.0},
          {"soft", soft ? 1.0 : 0.0, soft ? 1.0 : 0.0}};
}

double score(const std::vector<Mark>& marks) {
  double total = 0;
  for (const Mark& mark : marks) total += mark.verdict + 0.1 * mark.nearness;
  return total;
}

}  // namespace rubsweep::machine_search
