#include "machine_search/evaluation.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <ctime>
#include <numeric>

#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/run_cells.hpp"

namespace rubsweep::machine_search {
namespace {

/// Coarse grids with different columns and rows, so that a verdict based on few cells is noticed. Their rows
/// resolve small unbalance, where the tongues begin. The offset annulus has the same eccentricities as the
/// centred one, because an offset of a quarter leaves three quarters of the clearance.
struct Grid {
  const char* flat;
  const char* centred;
  const char* offset;
};
constexpr std::array<Grid, grid_count> grids{{
    {"speed_hz: {from: 48, to: 237, count: 43}, whirl_ratio: {values: [0.035, 0.05, 0.07, 0.1, 0.15, 0.25, "
     "0.35, "
     "0.5, 0.65, 0.8, 0.95]}",
     "speed_hz: {from: 48, to: 237, count: 22}, whirl_ratio: {values: [0.06, 0.12, 0.18, 0.3, 0.42, 0.54, "
     "0.66]}",
     "speed_hz: {from: 48, to: 237, count: 22}, whirl_ratio: {values: [0.08, 0.16, 0.24, 0.4, 0.56, 0.72, "
     "0.88]}"},
    {"speed_hz: {from: 46.5, to: 238.5, count: 41}, whirl_ratio: {values: [0.03, 0.045, 0.06, 0.08, 0.11, "
     "0.2, 0.3, "
     "0.45, 0.6, 0.75, 0.9]}",
     "speed_hz: {from: 46.5, to: 238.5, count: 21}, whirl_ratio: {values: [0.075, 0.15, 0.24, 0.36, 0.48, "
     "0.6, 0.72]}",
     "speed_hz: {from: 46.5, to: 238.5, count: 21}, whirl_ratio: {values: [0.1, 0.2, 0.32, 0.48, 0.64, 0.8, "
     "0.96]}"},
    {"speed_hz: {from: 45, to: 240, count: 53}, whirl_ratio: {values: [0.03, 0.04, 0.052, 0.068, 0.09, "
     "0.115, 0.15, "
     "0.2, 0.28, 0.38, 0.5, 0.62, 0.74, 0.86, 0.97]}",
     "speed_hz: {from: 45, to: 240, count: 31}, whirl_ratio: {values: [0.06, 0.09, 0.135, 0.21, 0.3, 0.39, "
     "0.48, 0.57, "
     "0.66]}",
     "speed_hz: {from: 45, to: 240, count: 31}, whirl_ratio: {values: [0.08, 0.12, 0.18, 0.28, 0.4, 0.52, "
     "0.64, 0.76, "
     "0.88]}"},
}};

/// On flat stops in one line, friction moves an isotropic rotor only along the walls. The findings concern
/// the motion across them, so friction is left out.
Candidate simplified(Candidate candidate, Arrangement arrangement) {
  if (arrangement != Arrangement::annulus && arrangement != Arrangement::annulus_with_offset)
    candidate.friction_coefficient = 0;
  return candidate;
}

Rows map_of(const Candidate& candidate, Arrangement arrangement, const char* grid) {
  const std::string text =
      machine_text(simplified(candidate, arrangement), arrangement) +
      fmt::format("sweep: {{{}}}\nresponse: {{max_revolutions: 600}}\noutput: {{directory: none}}\n", grid);
  sweep::Study study = config::read_run_config_text(text, "candidate.yaml", {}).study;
  // No mark depends on which of the aperiodic motions are chaotic.
  study.response.exponent = false;
  Rows rows(sweep::cell_count(study.grid));
  std::vector<std::size_t> cells(rows.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  const std::atomic<bool> stop = false;
  sweep::run_cells(
      study, cells, 1, [&](std::size_t cell, const sweep::Row& row) { rows[cell] = row; }, stop);
  return rows;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Largest sum of the marks for one arrangement.
double most(const std::vector<Mark>& marks) { return 1.1 * static_cast<double>(marks.size()); }

}  // namespace

Evaluation evaluate(const Candidate& candidate, std::size_t grid, double bar) {
  // The largest possible score is known before the maps: marks of empty maps show how many there are.
  const Rows none;
  double left = most(one_side_marks(none)) + most(both_sides_marks(none)) +
                most(unequal_casings_marks(none, none)) + most(annulus_marks(none)) +
                most(offset_marks(none, none)) + most(plausible_marks(candidate, {}));
  const double started_s = processor_seconds();
  Evaluation evaluation;
  const auto hopeless_after = [&](const std::vector<Mark>& marks) {
    evaluation.marks.insert(evaluation.marks.end(), marks.begin(), marks.end());
    evaluation.score = score(evaluation.marks);
    evaluation.processor_s = processor_seconds() - started_s;
    left -= most(marks);
    return evaluation.score + left <= bar;
  };
  const Grid& chosen = grids.at(grid);
  const Rows one_side = map_of(candidate, Arrangement::one_side, chosen.flat);
  if (hopeless_after(one_side_marks(one_side))) return evaluation;
  const Rows both_sides = map_of(candidate, Arrangement::both_sides, chosen.flat);
  if (hopeless_after(both_sides_marks(both_sides))) return evaluation;
  const Rows centred = map_of(candidate, Arrangement::annulus, chosen.centred);
  if (hopeless_after(annulus_marks(centred))) return evaluation;
  const Rows unequal = map_of(candidate, Arrangement::unequal_casings, chosen.flat);
  if (hopeless_after(unequal_casings_marks(unequal, both_sides))) return evaluation;
  const Rows offset = map_of(candidate, Arrangement::annulus_with_offset, chosen.offset);
  if (hopeless_after(offset_marks(offset, centred))) return evaluation;
  hopeless_after(plausible_marks(candidate, {&one_side, &both_sides, &unequal, &centred, &offset}));
  evaluation.complete = true;
  return evaluation;
}

}  // namespace rubsweep::machine_search
