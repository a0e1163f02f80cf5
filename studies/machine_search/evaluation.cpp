#include "machine_search/evaluation.hpp"

#include <fmt/format.h>

#include <atomic>
#include <ctime>
#include <numeric>

#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/sweep/run_cells.hpp"

namespace rubsweep::machine_search {
namespace {

// Coarse grids: enough speeds to meet every tongue, ratios where the findings differ. A cell of the annulus
// costs a hundred times as much, so that its maps are coarser. Their speeds are the same, two of them
// slightly above twice and two slightly above three times the natural frequency, where the paper has its
// subharmonics, and close together where circles end. The rows of both have the same unbalance: an offset of
// a quarter leaves three quarters of the clearance.
constexpr const char* one_side_grid =
    "sweep: {speed_hz: {from: 50, to: 215, count: 34}, whirl_ratio: {values: [0.04, 0.07, 0.1, 0.2, 0.4, "
    "0.7]}}\n"
    "response: {max_revolutions: 400}\n";
constexpr const char* two_stops_grid =
    "sweep: {speed_hz: {from: 50, to: 220, count: 18}, whirl_ratio: {values: [0.07, 0.12, 0.25, 0.5, 0.8]}}\n"
    "response: {max_revolutions: 250}\n";
constexpr const char* annulus_grid =
    "sweep: {speed_hz: {values: [55, 64, 71, 80, 94, 101, 115, 130, 150, 175, 205]},\n"
    "        whirl_ratio: {values: [0.15, 0.4, 0.675]}}\n"
    "response: {max_revolutions: 160}\n";
constexpr const char* offset_grid =
    "sweep: {speed_hz: {values: [55, 64, 71, 80, 94, 101, 115, 130, 150, 175, 205]},\n"
    "        whirl_ratio: {values: [0.2, 0.53333333333333333, 0.9]}}\n"
    "response: {max_revolutions: 128, window_revolutions: 32}\n";

/// Against flat stops on one line friction moves an isotropic rotor along the walls only, so that the motion
/// across them, which is what the findings are about, needs none.
Candidate simplified(Candidate candidate, Arrangement arrangement) {
  if (arrangement != Arrangement::annulus && arrangement != Arrangement::annulus_with_offset)
    candidate.friction_coefficient = 0;
  return candidate;
}

Rows map_of(const Candidate& candidate, Arrangement arrangement, const char* grid) {
  const std::string text =
      machine_text(simplified(candidate, arrangement), arrangement) + grid + "output: {directory: none}\n";
  sweep::Study study = config::read_run_config_text(text, "candidate.yaml", {}).study;
  // No mark asks which of the motions without a period are chaotic.
  study.response.exponent = false;
  Rows rows(sweep::cell_count(study.grid));
  std::vector<std::size_t> cells(rows.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  const std::atomic<bool> stop = false;
  sweep::run_cells(
      study, cells, 1, [&](std::size_t cell, const sweep::Row& row) { rows[cell] = row; }, stop);
  return rows;
}

/// A machine with less of figure 6 than this (of 7) is not looked at further, whatever the rest would show.
constexpr double least_one_side_score = 5;

/// Nor one whose centred annulus is mostly backward dry whip, which is none of the paper's motions and the
/// most expensive to follow.
constexpr double least_without_whip = 0.5;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

Evaluation evaluate(const Candidate& candidate, double bar) {
  // The score that is still possible is known before the maps: marks of no map at all carry the weights.
  double left = most(one_side_marks({})) + most(both_sides_marks({})) + most(unequal_casings_marks({})) +
                most(annulus_marks({})) + most(offset_marks({}, {}));
  const double started_s = processor_seconds();
  Evaluation evaluation;
  const auto hopeless_after = [&](const std::vector<Mark>& marks) {
    evaluation.marks.insert(evaluation.marks.end(), marks.begin(), marks.end());
    evaluation.score = sum(evaluation.marks);
    evaluation.processor_s = processor_seconds() - started_s;
    left -= most(marks);
    return evaluation.score + left <= bar;
  };
  if (hopeless_after(one_side_marks(map_of(candidate, Arrangement::one_side, one_side_grid))) ||
      evaluation.score < least_one_side_score)
    return evaluation;
  if (hopeless_after(both_sides_marks(map_of(candidate, Arrangement::both_sides, two_stops_grid))))
    return evaluation;
  if (hopeless_after(unequal_casings_marks(map_of(candidate, Arrangement::unequal_casings, two_stops_grid))))
    return evaluation;
  const Rows centred = map_of(candidate, Arrangement::annulus, annulus_grid);
  if (hopeless_after(annulus_marks(centred)) || evaluation.marks.back().value < least_without_whip)
    return evaluation;
  hopeless_after(offset_marks(map_of(candidate, Arrangement::annulus_with_offset, offset_grid), centred));
  evaluation.complete = true;
  return evaluation;
}

}  // namespace rubsweep::machine_search
