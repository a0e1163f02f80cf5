#include "design_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "design_tables.hpp"
#include "rubsweep/analysis/design/design_check.hpp"
#include "rubsweep/analysis/design/design_page.hpp"
#include "rubsweep/analysis/design/design_terms.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/place_arguments.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/working_time.hpp"

namespace rubsweep::apps {
namespace {

/// All files that a design check may write.
constexpr std::array<std::string_view, 7> check_file_names{
    "config.yaml", "design_check.csv",           "unbalance_response.csv", "lock_speeds.csv",
    "kicks.csv",   "design_check_other_end.csv", "config_other_end.yaml"};

/// Number of speeds at which the rotor's stability without stops is checked.
constexpr int premise_speeds = 121;

design::DesignQuestions questions_of(const RubtraceArguments& arguments, const sweep::Study& study) {
  const DesignCheckArguments& asked = arguments.design_check.value();
  design::DesignQuestions questions{
      operating_range(asked, study),      {},           asked.kick_speeds,
      batch::thread_count(asked.threads), asked.stages, asked.gas_density_kg_per_m3};
  if (arguments.place.has_unbalance()) {
    const scene::Unbalance unbalance = unbalance_of(arguments.place, study.machine);
    questions.eccentricity_m = std::get<scene::Eccentricity>(unbalance).value_m;
  }
  return questions;
}

void warn_of(const design::SpeedRange& operating, const sweep::Study& study,
             const scene::PreparedMachine& prepared) {
  warn_of_premises_at("rubtrace", batch::evenly_spaced(operating.from_hz, operating.to_hz, premise_speeds),
                      study, prepared);
}

std::string_view word_of(design::Answer answer) {
  constexpr std::array<std::string_view, 3> words{"pass", "NOT MET", "not told"};
  return words[static_cast<std::size_t>(answer)];
}

/// Pages of both ends behind the answer of both together.
std::string page_of(const RubtraceArguments& arguments, const design::DesignCheck& check,
                    const std::optional<design::DesignCheck>& other) {
  std::string page = design::design_page(check, arguments.shown);
  if (!other) return page;
  const design::Answer here = design::answer_of(check), there = design::answer_of(*other);
  const bool broken = here == design::Answer::not_met || there == design::Answer::not_met;
  return fmt::format(
      "answer    {}: {} as configured, {} at the other end of the bearings' clearances\n{}other end {}\n{}",
      word_of(broken ? design::Answer::not_met : std::max(here, there)), word_of(here), word_of(there), page,
      fmt::join(arguments.design_check->other_end, ", "), design::design_page(*other, arguments.shown));
}

/// Configuration at the other end of the clearances; messages name the option that its values come from.
config::RunConfig read_other_config(const RubtraceArguments& arguments) {
  const std::vector<std::string>& differs = arguments.design_check->other_end;
  std::vector<std::string> overrides = arguments.overrides;
  overrides.insert(overrides.end(), differs.begin(), differs.end());
  try {
    return config::read_run_config(arguments.config, overrides);
  } catch (const ConfigError& error) {
    std::string text = error.what();
    for (const std::string& one : differs) {
      const std::string value = config::yaml::shown(one, 200);
      boost::algorithm::replace_all(text, "--set " + value, "--other-end " + value);
    }
    throw ConfigError(text);
  }
}

}  // namespace

std::optional<OtherEnd> read_other_end(const RubtraceArguments& arguments) {
  if (arguments.design_check->other_end.empty()) return std::nullopt;
  const config::RunConfig config = read_other_config(arguments);
  ask("rubtrace", config.questions, arguments.quiet);
  OtherEnd other{config, scene::prepare_machine(config.study.machine), questions_of(arguments, config.study)};
  const model::Machine& machine = config.study.machine;
  const auto [from_hz, to_hz] = design::whole_range(machine, other.questions.operating);
  structure::refuse_beyond_tables(machine, from_hz, to_hz);
  if (!other.questions.eccentricity_m)
    other.questions.eccentricity_m = design::analysis_eccentricity_m(machine, to_hz);
  if (!arguments.quiet) warn_of(other.questions.operating, config.study, other.prepared);
  return other;
}

design::SpeedRange operating_range(const DesignCheckArguments& arguments, const sweep::Study& study) {
  if (arguments.operating) {
    require_speed(arguments.operating_option, arguments.operating->from_hz, study.machine);
    require_speed(arguments.operating_option, arguments.operating->to_hz, study.machine);
    return *arguments.operating;
  }
  const auto [low, high] = std::ranges::minmax(study.grid.speed_hz);
  if (low < high) return {low, high};
  throw UsageError(
      "--design-check: the sweep has one speed, and the operating range needs two: --operating-hz FROM:TO");
}

int run_design_check(const RubtraceArguments& arguments, const config::RunConfig& config,
                     const std::filesystem::path& directory) {
  const sweep::Study& study = config.study;
  const design::DesignQuestions questions = questions_of(arguments, study);
  batch::require_threads(questions.threads);
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  if (!arguments.quiet) warn_of(questions.operating, study, prepared);
  const std::optional<OtherEnd> other_end = read_other_end(arguments);
  const ResultDirectory made(directory, check_file_names);
  std::optional<WorkingTime> working(std::in_place, "rubtrace", "checks the design", !arguments.quiet);
  const design::DesignCheck check = design::check_design(study, prepared, questions);
  std::optional<design::DesignCheck> other;
  if (other_end)
    other = design::check_design(other_end->config.study, other_end->prepared, other_end->questions);
  working.reset();
  DesignTables tables = tables_of(check);
  batch::ResultFiles files{
      {"config.yaml", config::print_config(config)},
      {"design_check.csv", std::move(tables.design_check_csv)},
      {"unbalance_response.csv", std::move(tables.unbalance_response_csv)},
      {"lock_speeds.csv", std::move(tables.lock_speeds_csv)},
      {"kicks.csv", std::move(tables.kicks_csv)},
      {"design_check_other_end.csv", other ? tables_of(*other).design_check_csv : std::string()},
      {"config_other_end.yaml", other ? config::print_config(other_end->config) : std::string()}};
  std::erase_if(files, [](const auto& file) { return file.second.empty(); });
  {
    const InterruptsWait whole_set;
    batch::write_result_files(
        files, check_file_names, directory,
        {"rubsweep", config::study_digest(study), batch::caption_lines(config.captions)});
    end_on_interrupts("the files are written, no figure is");
  }
  if (!arguments.quiet) print("{}{}", page_of(arguments, check, other), batch::files_line(files, directory));
  draw_and_say(arguments.figure, "design", directory,
               "Design check, " + model::speed_range_text(check.operating.from_hz, check.operating.to_hz, 4),
               arguments.quiet);
  const bool passed = design::answer_of(check) == design::Answer::pass &&
                      (!other || design::answer_of(*other) == design::Answer::pass);
  return arguments.design_check->require_pass && !passed ? some_cells_failed : done;
}

}  // namespace rubsweep::apps
