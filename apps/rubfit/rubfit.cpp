#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "fitted_machine.hpp"
#include "rubfit/fit_tables.hpp"
#include "rubfit_arguments.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/measurement/fit/modelled_data.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/kept_files.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/run_summary.hpp"

namespace rubsweep::apps {
namespace {

/// All files that a fit may write.
constexpr std::array<std::string_view, 4> file_names{"config.yaml", "parameters.csv", "correlation.csv",
                                                     "fitted.csv"};

/// Progress of a fit on a terminal. The number of steps is not known in advance; a start takes about ten.
class Steps {
 public:
  explicit Steps(bool shown) : shown_(shown && isatty(STDERR_FILENO) != 0) {}
  ~Steps() {
    if (shown_ && any_) put("\n");
  }
  Steps(const Steps&) = delete;
  Steps& operator=(const Steps&) = delete;

  void operator()(int start, int step, double cost, int starts) {
    if (!shown_) return;
    const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    constexpr double usual_steps = 10;
    const double done = start + std::min(1.0, step / usual_steps);
    const std::string left =
        done > 0 ? batch::hours_minutes_seconds(elapsed_s * std::max(0.0, starts - done) / done) : "?";
    put(fmt::format("\rstart {} of {}, step {}, sum of squares {:.6g}, about {} left ", start + 1, starts,
                    step, 2 * cost, left));
    any_ = true;
  }

 private:
  static void put(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
  }

  bool shown_, any_ = false;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

int nothing_was_found() {
  say("rubfit: interrupted; nothing was written\n");
  remove_empty_result_directories();
  return 128 + caught_signal();
}

/// Largest residual share of the tables whose phase convention can be chosen; 0 without such tables.
double left_of_tables(const fit::MachineFit& problem, const Eigen::VectorXd& values) {
  double most = 0;
  for (std::size_t i = 0; i < problem.data.size(); ++i)
    if (has_phases_of_a_table(problem.data[i]))
      most = std::max(most, fit::what_is_left(problem, i, values).share());
  return most;
}

/// If no phase convention is given and `sensor` fits badly, chooses the convention of the tables that fits
/// best. Returns the line that reports the convention; empty without tables.
std::string choose_phases(const RubfitArguments& arguments,
                          const std::function<fit::MachineFitResult(const fit::MachineFit&, int)>& found,
                          FittedMachine& fitted, fit::MachineFitResult& result) {
  using enum fit::PhaseConvention;
  constexpr double too_much = 0.1, far_less = 0.5;
  if (!std::ranges::any_of(fitted.problem.data, fit::has_phases_of_a_table)) return {};
  fit::PhaseConvention taken = arguments.phases.value_or(sensor);
  const double left = left_of_tables(fitted.problem, result.fit.value);
  std::string doubt;
  if (!arguments.phases && left > too_much && !result.fit.stopped) {
    double least = far_less * left;
    for (const auto other : {lag, mark}) {
      FittedMachine turned = fitted;
      take_phases_as(other, taken, turned);
      fit::MachineFitResult next = found(turned.problem, arguments.starts);
      if (next.fit.stopped || next.fit.value.size() == 0) break;
      const double left_so = left_of_tables(turned.problem, next.fit.value);
      if (!(left_so < least)) continue;
      least = left_so;
      taken = other;
      fitted = std::move(turned);
      result = std::move(next);
    }
    if (taken != sensor)
      doubt = fmt::format(
          "warning   phases are taken as --phase {}, which leaves {:.2g} %; --phase sensor leaves {:.0f} %\n",
          name_of(taken), 100 * least, 100 * left);
  }
  return fmt::format("phases    of tables: {} (--phase {})\n{}",
                     taken == lag    ? "lag of the positive peak behind the mark"
                     : taken == mark ? "from the one mark, negative lags"
                                     : "from where the mark passes each sensor, negative lags",
                     name_of(taken), doubt);
}

int run(const RubfitArguments& arguments) {
  const config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  ask("rubfit", config.questions, arguments.quiet);
  FittedMachine fitted = fitted_machine_of(arguments, config);
  const fit::MachineFit& problem = fitted.problem;
  const std::filesystem::path directory = results_directory(arguments, config.output_directory, "_fit");
  const ResultDirectory made(directory, file_names);
  const std::atomic<bool>& stop = catch_interrupts();
  fit::LeastSquaresOptions options{
      .robust_beyond = arguments.robust_beyond, .starts = arguments.starts, .stop = &stop};
  // One evaluation of the model may take longer than a user waits after an interrupt.
  std::optional<Watch> watch(
      std::in_place, [] {}, [] { std::_Exit(nothing_was_found()); });
  const auto found = [&](const fit::MachineFit& asked, int starts) {
    Steps steps(!arguments.quiet);
    options.on_iteration = [&](int start, int step, double cost) { steps(start, step, cost, starts); };
    return fit::fit_machine(asked, options);
  };
  fit::MachineFitResult result = found(problem, arguments.starts);
  watch.reset();
  if (result.fit.value.size() == 0) return nothing_was_found();
  const std::string phases = choose_phases(arguments, found, fitted, result);
  FitTables tables = tables_of(problem, result, config.study.machine);
  if (!arguments.without.empty() && !result.fit.stopped) {
    const fit::MachineFitResult less = found(without(fitted, arguments.without), arguments.starts);
    // If the second fit is interrupted, the first one is still complete.
    if (!less.fit.stopped)
      tables.summary += comparison_text(result, less, fmt::format("{}", fmt::join(arguments.without, ", ")));
  }
  count_in_summary("parameters", static_cast<std::size_t>(result.fit.value.size()));
  const batch::ResultFiles files{{"config.yaml", fitted_config(fitted, result.fit.value)},
                                 {"parameters.csv", std::move(tables.parameters_csv)},
                                 {"correlation.csv", std::move(tables.correlation_csv)},
                                 {"fitted.csv", std::move(tables.residuals_csv)}};
  batch::write_result_files(files, file_names, directory, {"rubfit", config::study_digest(config.study), {}});
  if (!arguments.quiet) print("{}{}{}", phases, tables.summary, batch::files_line(files, directory));
  if (stop) {
    say("rubfit: interrupted; the best so far is written\n");
    return 128 + caught_signal();
  }
  if (arguments.figure) end_on_interrupts("the files are written, no figure is");
  draw_and_say(arguments.figure, "fit", directory, arguments.config.filename().string(), arguments.quiet);
  return result.fit.converged ? done : some_cells_failed;
}

int perform(const RubfitArguments& arguments) {
  if (answered("rubfit", arguments.action, rubfit_help)) return done;
  return run(arguments);
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubfit", [&] { return perform(parse_rubfit_arguments(argc, argv)); });
}
