#include "rubsweep/config/keys/options_form.hpp"

#include "rubsweep/config/keys/fields.hpp"
#include "rubsweep/config/yaml/words.hpp"
#include "rubsweep/integrate/adaptive/stepper_table.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::config::keys {
namespace {

template <class Enum>
Form word_of() {
  std::vector<std::string> words;
  for (const std::string_view text : yaml::words_of<Enum>().texts) words.emplace_back(text);
  return word(std::move(words));
}

Form stepper_word() {
  std::vector<std::string> words;
  for (const auto& row : integrate::adaptive::stepper_table()) words.emplace_back(row.word);
  return word(std::move(words));
}

}  // namespace

Form solver_form() {
  using integrate::run::SolverOptions;
  const SolverOptions defaults;
  return map_of(
      {may("method", word_of<integrate::run::Method>(),
           "closed forms and Taylor pieces (exact), steppers (adaptive), or exact wherever it applies (auto)",
           std::string(to_string(defaults.method))),
       may("stepper", stepper_word(), "stepper of the adaptive solver's turns", "auto"),
       may("contact", word_of<integrate::run::ContactHandling>(),
           "changes of contact mode found to rounding, or a law that is blended",
           std::string(to_string(defaults.contact))),
       may("relative_tolerance", number(SolverOptions::relative_tolerance_range),
           "tolerance of the adaptive solver's turns", shortest(defaults.relative_tolerance)),
       may("smoothing_m", number(SolverOptions::smoothing_range), "width of the blend of contact: smoothed",
           shortest(defaults.smoothing_m)),
       may("max_steps_per_revolution", integer(SolverOptions::max_steps_low, 1'000'000'000),
           "steps that end a run as step_limit", std::to_string(defaults.max_steps_per_revolution))});
}

Form response_form() {
  const response::motion::ResponseOptions defaults;
  const sweep::Neighbours neighbours;
  const Form switches = word({"off", "on", "probability"});
  const Condition probability{"robustness", {"probability"}};
  return map_of(joined(
      {{may("max_revolutions", integer(2, 10'000'000), "revolutions at which a run ends at the latest",
            std::to_string(defaults.max_revolutions)),
        may("samples_per_revolution", even_integer(4, 4096), "samples of the last two windows",
            std::to_string(defaults.samples_per_revolution)),
        may("window_revolutions", integer(2, 4096), "length of a window",
            std::to_string(defaults.window_revolutions)),
        may("max_order", integer(1, 1024), "largest n of a 1/n motion that is looked for",
            std::to_string(defaults.max_order)),
        may("floquet_proof", word({"off", "on"}), "whether a run ends as soon as a stable orbit is proven",
            "on"),
        may("robustness", switches, "more runs of each cell with other kicks: two, or many", "off")},
       newer(
           {beside(may("robustness_neighbours", even_integer(2, 1000),
                       "how many other kicks, half of them weaker", std::to_string(neighbours.count)),
                   probability),
            beside(may("robustness_part", number({.low = 0, .high = 1, .low_open = true, .high_open = true}),
                       "largest relative change of the force", shortest(neighbours.part)),
                   probability),
            may("hertz_iterations", integer(0, 20),
                "how often a cell whose force leaves the range of a hertz stiffness is run again", "0")})}));
}

}  // namespace rubsweep::config::keys
