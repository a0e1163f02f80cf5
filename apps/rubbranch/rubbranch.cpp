#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "branch_family.hpp"
#include "branch_plane.hpp"
#include "cell_on_axes.hpp"
#include "rubbranch_arguments.hpp"
#include "rubbranch_curves.hpp"
#include "rubbranch_map.hpp"
#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/kept_files.hpp"
#include "shared/place_arguments.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/run_summary.hpp"
#include "shared/working_time.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> file_names{"config.yaml", "branch.csv", "events.csv", "curves.csv",
                                                     "meetings.csv"};

branch::orbits::OrbitProblem problem_of(const BranchFamily& family, branch::orbits::Closing closing,
                                        int order, const sweep::Study& study,
                                        response::motion::Workspace& workspace) {
  branch::orbits::OrbitProblem problem =
      branch::orbits::closed_orbits(closing, family.scenes, order, study.solver, workspace.modes);
  problem.low = family.low;
  problem.high = family.high;
  problem.parameter_scale = family.high - family.low;
  return problem;
}

/// Adds, for every period doubling of a branch, the branch of double period, if it is found.
void add_doubled(const BranchFamily& family, branch::orbits::Closing closing,
                 const branch::continuation::FollowOptions& options, const sweep::Study& study,
                 response::motion::Workspace& workspace,
                 std::vector<branch::continuation::Branch>& branches) {
  const branch::continuation::Branch single = branches.front();
  const branch::orbits::OrbitProblem problem =
      problem_of(family, closing, 2 * single.order, study, workspace);
  for (const branch::continuation::BranchEvent& event : single.events) {
    if (event.kind != branch::continuation::EventKind::period_doubling) continue;
    const auto start = branch::continuation::doubled_start(problem, event.point);
    if (!start) {
      say(fmt::format("rubbranch: no orbit of twice the period is found beside the doubling at {:.10g}\n",
                      event.point.parameter));
      continue;
    }
    branch::continuation::HalfBranch half = branch::continuation::follow(problem, *start, options);
    branches.push_back({problem.order, std::move(half.points), std::move(half.events),
                        branch::continuation::Ending::period_halving, half.ending});
  }
}

int nothing_to_follow(const std::string& why) {
  say(fmt::format("rubbranch: {}; nothing is written\n", why));
  return some_cells_failed;
}

batch::ResultFiles files_of(const RubbranchArguments& arguments, const config::RunConfig& config,
                            const std::vector<branch::continuation::Branch>& branches,
                            const std::vector<CurveFrom>& curves) {
  const std::string comments = branch::continuation::branch_comments(arguments.along, branches);
  batch::ResultFiles files{{"config.yaml", config::print_config(config)},
                           {"branch.csv", comments + branch::continuation::branch_csv(branches)},
                           {"events.csv", comments + branch::continuation::branch_events_csv(branches)}};
  if (!arguments.curve.empty()) {
    const std::string head = curve_comments(arguments.along, arguments.curve, curves);
    files["curves.csv"] = head + curves_csv(curves);
    files["meetings.csv"] = head + meetings_csv(curves);
  }
  return files;
}

void check_cell(const RubbranchArguments& arguments, const config::RunConfig& config) {
  const sweep::Study& study = config.study;
  ask("rubbranch", config.questions, arguments.quiet);
  ask_about("rubbranch", sweep::unbalance_of(study.grid, arguments.cell.unbalance), study.machine,
            arguments.quiet);
  require_speed("--cell", arguments.cell.speed_hz, study.machine);
  if (arguments.along == "speed_hz" && arguments.to) require_speed("--to", *arguments.to, study.machine);
}

int run(const RubbranchArguments& arguments, const config::RunConfig& config) {
  const sweep::Study& study = config.study;
  check_cell(arguments, config);
  const BranchFamily family = branch_family(arguments, config);
  std::optional<BranchPlane> plane;
  if (!arguments.curve.empty()) plane = branch_plane(arguments, config);
  const fs::path directory = results_directory(arguments, config.output_directory, "_branch");
  const ResultDirectory made(directory, file_names);
  end_on_interrupts("nothing was written");

  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  if (!arguments.quiet) warn_of_premises_at("rubbranch", {arguments.cell.speed_hz}, study, prepared);
  const scene::Cell cell = scene::build_cell(prepared, arguments.cell.speed_hz,
                                             sweep::unbalance_of(study.grid, arguments.cell.unbalance));
  if (!scene::can_run(cell.start)) return nothing_to_follow("the cell has no motion that could be run");
  std::optional<WorkingTime> working(std::in_place, "rubbranch", "waits until the motion has settled",
                                     !arguments.quiet);
  response::motion::Workspace workspace;
  const branch::orbits::SettledStart settled =
      branch::orbits::settle_on_orbit(cell, study.solver, study.response, workspace);
  working.reset();
  if (!settled.order) {
    return nothing_to_follow(fmt::format("the cell settles on no periodic orbit in contact, its motion is {}",
                                         to_string(settled.motion_class)));
  }
  const branch::orbits::Closing closing = settled.closing;
  if (plane && closing == branch::orbits::Closing::in_the_turning_frame)
    return nothing_to_follow(
        "--curve: an oval, which closes in the turning frame, has no curves in two parameters");
  const branch::orbits::OrbitProblem problem = problem_of(family, closing, *settled.order, study, workspace);
  const auto start = branch::continuation::orbit_from(problem, settled.state, family.start);
  if (!start) return nothing_to_follow("Newton's iteration does not find the orbit that the cell settles on");
  working.emplace("rubbranch", "follows the orbit", !arguments.quiet);
  branch::continuation::FollowOptions options;
  options.most_points = arguments.most_points;
  std::vector<branch::continuation::Branch> branches{
      branch::continuation::follow_both_ways(problem, *start, options)};
  if (arguments.switch_at_doublings) add_doubled(family, closing, options, study, workspace, branches);

  std::vector<CurveFrom> curves;
  if (plane)
    curves = curves_of(branches, *plane, {family.low, family.high}, study, arguments.most_points, workspace);

  const batch::ResultFiles files = files_of(arguments, config, branches, curves);
  working.reset();
  count_in_summary("branches", branches.size());
  count_in_summary("curves", curves.size());
  const InterruptsWait whole_set;
  batch::write_result_files(
      files, file_names, directory,
      {"rubbranch", config::study_digest(study), batch::caption_lines(config.captions)});
  if (!arguments.quiet) {
    print("{}{}{}", branch::continuation::branch_summary(arguments.along, branches),
          curves_summary(arguments.along, arguments.curve, curves), batch::files_line(files, directory));
  }
  return done;
}

/// Writes the keys of a cell on axes over keys into its configuration, and follows its branch.
int run_on_cell(RubbranchArguments arguments) {
  config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  CellOnAxes placed = cell_on_axes(arguments.cell_values, config.study.grid, arguments.overrides);
  arguments.cell = placed.cell;
  if (placed.overrides.empty()) return run(arguments, config);
  std::ranges::move(placed.overrides, std::back_inserter(arguments.overrides));
  return run(arguments, config::read_run_config(arguments.config, arguments.overrides));
}

int perform(const RubbranchArguments& arguments) {
  if (answered("rubbranch", arguments.action, rubbranch_help)) return done;
  if (!arguments.map.empty()) return run_on_map(arguments);
  return run_on_cell(arguments);
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubbranch", [&] { return perform(parse_rubbranch_arguments(argc, argv)); });
}
