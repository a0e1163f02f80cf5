#include "shared/missing_cells.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <utility>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/map/missing_cells.hpp"
#include "shared/interrupt.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {

std::optional<std::size_t> compute_missing_cells(const SweepRun& how, const sweep::Study& study,
                                                 map::MapDirectory& directory) {
  if (!how.quiet && directory.finished() > 0) {
    say(fmt::format("{}: {} of {} cells were finished before\n", how.program, directory.finished(),
                    directory.cells()));
  }
  if (directory.missing().empty() && !study.grid.refinement) return 0;
  std::optional<scene::PreparedMachine> prepared;
  if (!how.quiet)
    warn_of_premises(how.program, study, prepared.emplace(scene::prepare_machine(study.machine)));
  map::MissingCells missing({.threads = how.threads,
                             .stop = &catch_interrupts(),
                             .progress = how.quiet ? batch::ProgressMode::never : how.progress,
                             .program = how.program,
                             .prepared = std::move(prepared)},
                            study, directory);
  bool finished = false;
  {
    const Watch watch([&] { missing.refresh(); },
                      [&] {
                        if (!missing.give_up()) return;
                        say(missing.interrupted());
                        std::_Exit(128 + caught_signal());
                      });
    finished = missing.run();
  }
  if (!finished) {
    say(missing.interrupted());
    return std::nullopt;
  }
  if (!how.quiet && !missing.description().empty()) say(missing.description());
  return missing.left_to_others();
}

}  // namespace rubsweep::apps
