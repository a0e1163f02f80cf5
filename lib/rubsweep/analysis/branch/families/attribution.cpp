#include "rubsweep/analysis/branch/families/attribution.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <utility>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/structure/stability.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::branch::families {
namespace {

/// Attribution of an edge from one side: follows the family to which the kick of `cell` leads to a neighbour.
MapEdge seen_from(std::size_t cell, std::size_t neighbour, const Family& family) {
  MapEdge edge{cell, neighbour, Attribution::unresolved, {}};
  if (const FamilyEnd* end = family.end_between(cell, neighbour)) {
    edge.kind = end->kind;
    if (is_an_end(end->kind)) edge.attribution = Attribution::ceases;
  } else if (family.orbits.contains(neighbour)) {
    edge.attribution = Attribution::basin;
  }
  return edge;
}

/// Attribution of an edge by the quiet motion, which depends on the two cells, not on the way between them.
MapEdge quiet_seen_from(std::size_t cell, std::size_t neighbour, std::span<const Quiet> quiet) {
  MapEdge edge{cell, neighbour, Attribution::unresolved, {}};
  if (quiet[cell] != Quiet::stable) return edge;
  switch (quiet[neighbour]) {
    case Quiet::stable: edge.attribution = Attribution::basin; break;
    case Quiet::unstable:
      edge.attribution = Attribution::ceases;
      edge.kind = to_string(continuation::EventKind::stability);
      break;
    case Quiet::touches:
      edge.attribution = Attribution::ceases;
      edge.kind = to_string(continuation::EventKind::graze);
      break;
  }
  return edge;
}

/// Stronger of the attributions from the two sides: `ceases` before a motion that exists on both sides.
MapEdge together(const MapEdge& there, const MapEdge& back) {
  const bool stronger =
      back.attribution < there.attribution || (back.attribution == there.attribution && there.kind.empty());
  MapEdge edge = stronger ? back : there;
  if (edge.attribution == Attribution::basin && there.attribution != back.attribution) edge.kind = one_motion;
  return edge;
}

thread_local response::motion::Workspace workspace;

class Checker {
 public:
  Checker(const sweep::Study& study, std::span<const std::string> labels, const Families& families)
      : study_(study),
        prepared_(scene::prepare_machine(study.machine)),
        labels_(labels),
        families_(families),
        family_of_(labels.size()) {
    for (std::size_t i = 0; i < families.list.size(); ++i)
      for (const std::size_t cell : families.list[i].reached) family_of_[cell] = i;
  }

  /// Checks of all cells inside a family. Where the kick does not lead to the orbit, `stays` decides later.
  std::vector<LabelCheck> inside(std::size_t number) const {
    const Family& family = families_.list[number];
    std::vector<LabelCheck> checks;
    for (const auto& [cell, orbit] : family.orbits) {
      const bool reached = std::ranges::binary_search(family.reached, cell);
      checks.push_back({cell, number, true, reached ? CheckResult::reached : CheckResult::stays, {}, {}});
    }
    return checks;
  }

  /// Whether the machine, started on the orbit, settles on it.
  bool stays(std::size_t number, const CellOrbit& orbit) const {
    const scene::Place place = sweep::place_of(study_.grid, number);
    scene::Cell cell = scene::build_cell(prepared_, place.speed_hz, place.unbalance);
    cell.scene = response::proof::after_the_kick(std::move(cell.scene));
    // The state of an oval is followed by its loop time, which is left out here.
    const Eigen::Index numbers = 2 * cell.scene.displacement_m.size();
    integrate::run::set_initial_state(cell.scene, {orbit.state.data(), static_cast<std::size_t>(numbers)});
    const orbits::SettledStart settled =
        orbits::settle_on_orbit(cell, study_.solver, study_.response, workspace);
    const auto there = stable_orbit(study_, prepared_, number, settled, workspace);
    return there && same_orbit(study_, prepared_, number, orbit, *there, workspace);
  }

  std::vector<LabelCheck> outside(std::size_t number) const {
    const Family& family = families_.list[number];
    std::vector<LabelCheck> checks;
    for (const FamilyEnd& end : family.ends) {
      // The cell belongs to the domain if the family enters it from another neighbour.
      if (family.orbits.contains(end.outside) || labels_[end.outside] != labels_[family.seed]) continue;
      checks.push_back(
          {end.outside, number, false, found_outside(family, end), end.kind, family_of_[end.outside]});
    }
    return checks;
  }

 private:
  CheckResult found_outside(const Family& family, const FamilyEnd& end) const {
    const auto other_number = family_of_[end.outside];
    if (!other_number) {
      const bool proven =
          std::ranges::find(families_.not_followed, end.outside) != families_.not_followed.end();
      return proven ? CheckResult::not_found : CheckResult::unproven;
    }
    if (!is_an_end(end.kind)) return CheckResult::not_followed;
    const Family& other = families_.list[*other_number];
    if (const auto there = other.orbits.find(end.inside); there != other.orbits.end()) {
      const bool same =
          same_orbit(study_, prepared_, end.inside, there->second, family.orbits.at(end.inside), workspace);
      return same ? CheckResult::same_orbit : CheckResult::another_orbit;
    }
    const FamilyEnd* on_the_way_in = other.end_between(end.outside, end.inside);
    return on_the_way_in && is_an_end(on_the_way_in->kind) ? CheckResult::ends_as_well
                                                           : CheckResult::not_followed;
  }

  const sweep::Study& study_;
  scene::PreparedMachine prepared_;
  std::span<const std::string> labels_;
  const Families& families_;
  std::vector<std::optional<std::size_t>> family_of_;
};

}  // namespace

std::vector<Quiet> quiet_cells(const sweep::Study& study) {
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  std::vector<bool> grows;
  for (const double speed_hz : study.grid.speed_hz)
    grows.push_back(structure::grows(prepared.assembly, 2 * std::numbers::pi * speed_hz));
  std::vector<Quiet> cells;
  for (const double unbalance : study.grid.unbalance) {
    for (std::size_t i = 0; i < grows.size(); ++i) {
      const scene::Cell cell =
          scene::build_cell(prepared, study.grid.speed_hz[i], sweep::unbalance_of(study.grid, unbalance));
      cells.push_back(cell.start != scene::Start::quiet ? Quiet::touches
                      : grows[i]                        ? Quiet::unstable
                                                        : Quiet::stable);
    }
  }
  return cells;
}

bool is_an_end(std::string_view kind) {
  constexpr std::array endings{continuation::Ending::left_range, continuation::Ending::failed,
                               continuation::Ending::step_too_small, continuation::Ending::singular,
                               continuation::Ending::point_limit};
  return std::ranges::none_of(endings,
                              [&](continuation::Ending ending) { return to_string(ending) == kind; });
}

std::vector<MapEdge> attribute(const sweep::Grid& grid, std::span<const std::string> labels,
                               const std::vector<Family>& families, std::span<const Quiet> quiet,
                               std::string_view quiet_label) {
  std::vector<const Family*> family_of(labels.size(), nullptr);
  for (const Family& family : families)
    for (const std::size_t cell : family.reached) family_of[cell] = &family;
  const auto seen = [&](std::size_t cell, std::size_t neighbour) -> MapEdge {
    if (family_of[cell] != nullptr) return seen_from(cell, neighbour, *family_of[cell]);
    if (labels[cell] == quiet_label) return quiet_seen_from(cell, neighbour, quiet);
    return {cell, neighbour, Attribution::unresolved, {}};
  };
  std::vector<MapEdge> edges;
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    for (const std::size_t next : neighbours_of(grid, cell)) {
      if (next < cell || labels[cell] == labels[next]) continue;
      MapEdge edge = together(seen(cell, next), seen(next, cell));
      edge.first = cell;
      edge.second = next;
      edges.push_back(edge);
    }
  }
  return edges;
}

std::vector<LabelCheck> check_labels(const sweep::Study& study, std::span<const std::string> labels,
                                     const Families& families, int threads, const std::atomic<bool>& stop,
                                     FamilyRecords& records) {
  const Checker checker(study, labels, families);
  std::vector<LabelCheck> checks;
  std::vector<std::size_t> to_run;
  const auto seed_of = [&](const LabelCheck& check) { return families.list[*check.family].seed; };
  for (std::size_t number = 0; number < families.list.size(); ++number) {
    for (LabelCheck& check : checker.inside(number)) {
      const std::optional<bool> known = records.stays(families.list[number].seed, check.cell);
      if (check.finding == CheckResult::stays && !known) to_run.push_back(checks.size());
      if (check.finding == CheckResult::stays && known == false) check.finding = CheckResult::leaves;
      checks.push_back(check);
    }
    std::ranges::copy(checker.outside(number), std::back_inserter(checks));
  }
  batch::parallel_run(
      to_run.size(), threads,
      [&](std::size_t i) {
        LabelCheck& check = checks[to_run[i]];
        const bool stays = checker.stays(check.cell, families.list[*check.family].orbits.at(check.cell));
        check.finding = stays ? CheckResult::stays : CheckResult::leaves;
      },
      [&](std::size_t i) {
        const LabelCheck& check = checks[to_run[i]];
        records.keep_stays(seed_of(check), check.cell, check.finding == CheckResult::stays);
      },
      stop);
  for (const std::size_t cell : families.not_followed)
    checks.push_back({cell, {}, true, CheckResult::not_found, {}, {}});
  return checks;
}

}  // namespace rubsweep::branch::families
