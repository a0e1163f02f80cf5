#include "shared/study_questions.hpp"

#include <fmt/format.h>

#include <utility>

#include "explain/explain_study.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/grid.hpp"
#include "rubsweep/maps/sweep/study_warnings.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

/// Asks about a kick that reaches no wall from any cell.
void ask_about_weak_kick(std::string_view program, const StudyArguments& arguments, const sweep::Study& study,
                         const scene::PreparedMachine& prepared) {
  const auto least_n = sweep::least_kick_force_n(study, prepared);
  if (!least_n) return;
  constexpr std::string_view key = "kick.force_n";
  ask(program,
      {fmt::format("{}: {}: {} N reach no wall from any cell (more than {:.3g} N?)",
                   config::place_of_key(arguments.config, arguments.overrides, key), key,
                   study.machine.kick->force_n, *least_n)},
      arguments.quiet);
}

}  // namespace

StudyActions study_actions(std::string_view program, const StudyArguments& arguments,
                           const config::RunConfig& config, std::function<int()> run) {
  return {.size =
              [&, program] {
                // Throws where no structure can be computed from the numbers.
                const scene::PreparedMachine prepared = scene::prepare_machine(config.study.machine);
                warn_of_premises(program, config.study, prepared);
                ask_about_weak_kick(program, arguments, config.study, prepared);
                return fmt::format("{} cells", sweep::cell_count(config.study.grid));
              },
          .explanation = [&] { return explain_study(config.study); },
          .configuration = [&] { return config::print_config(config); },
          .run = std::move(run)};
}

}  // namespace rubsweep::apps
