#include "rubsweep/maps/config/keys/run_form.hpp"

#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "rubsweep/maps/basin/low_discrepancy.hpp"
#include "rubsweep/maps/config/keys/axis_form.hpp"
#include "rubsweep/maps/config/keys/fields.hpp"
#include "rubsweep/maps/config/keys/machine_form.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/words.hpp"
#include "rubsweep/maps/sweep/study.hpp"

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

Form refine() {
  return map_of(
      {must("levels", integer(1, 12), "the map begins with every 2^levels-th cell of both axes"),
       may("probes", integer(0, 1000), "further cells inside every block between those lines", "0")});
}

Form sweep_form() {
  const Form speeds = axis(model::positive), unbalances = axis(model::not_negative);
  const auto over_keys = [](const char* name, const char* meaning) {
    return may(
        name,
        map_of(joined({key_axis_keys(), spaced_keys(model::any_finite)}), {key_axis_ways(), spaced_ways()}),
        meaning, "(none)");
  };
  std::vector<Key> keys = joined(
      {{must("speed_hz", speeds, "shaft speeds, in revolutions per second"),
        must("whirl_ratio", unbalances,
             "unbalance: excursion of the quiet motion / clearance left at the first stop"),
        must("eccentricity_m", unbalances, "unbalance by the eccentricity of the disc")},
       newer({must("speed_rpm", speeds, "shaft speeds, in revolutions per minute"),
              must("unbalance_g_mm", unbalances, "unbalance by U: the eccentricity is U / m"),
              must("balance_grade_mm_per_s", unbalances,
                   "unbalance by the balance quality grade G of ISO 21940-11, at the rated speed"),
              must("rated_speed_hz", number(model::positive), "speed that a grade is taken at"),
              must("rated_speed_rpm", number(model::positive), "the same, in revolutions per minute"),
              over_keys("x", "axis over other keys of the configuration"),
              over_keys("y", "a second axis over other keys"), over_keys("z", "a third axis over other keys"),
              may("refine", refine(), "a map without most of its cells, split where neighbours differ",
                  "(none)")})});
  Choice speed{{{{"speed_hz"}, {}}, {{"speed_rpm"}, {}}}};
  Choice unbalance{{{{"whirl_ratio"}, {}},
                    {{"eccentricity_m"}, {}},
                    {{"unbalance_g_mm"}, {}},
                    {{"balance_grade_mm_per_s", "rated_speed_hz"}, {}},
                    {{"balance_grade_mm_per_s", "rated_speed_rpm"}, {}}}};
  return map_of(std::move(keys), {std::move(speed), std::move(unbalance)});
}

Form drawn_key() {
  return map_of({must("key", text(), "key that is drawn, as --set names it"),
                 must("from", number({}), "one end of its interval"), must("to", number({}), "the other end"),
                 may("scale", word({"linear", "log"}), "evenly, or evenly in ratios", "linear")});
}

Form study_form() {
  const Condition threshold{"kind", {"threshold"}}, basin{"kind", {"basin"}};
  Form scan =
      map_of({must("kind", word({"threshold"}),
                   "after which numbers of a key rub goes on (threshold), where starts lead (basin), or "
                   "nothing more (map)"),
              may("tolerance", number({.low = 1e-12, .high = 0.5}),
                  "to which a beginning or an end of rub is bisected, relative to it",
                  shortest(sweep::ThresholdScan{}.tolerance))},
             {key_axis_ways(), spaced_ways()});
  for (Key& key : joined({key_axis_keys(), spaced_keys({})})) scan.keys.push_back(std::move(key));
  Form samples = map_of({must("kind", word({"basin"}), "basin"),
                         must("samples", integer(1, 1'000'000), "how many starts each cell is run from"),
                         must("over", list_of(drawn_key(), 1, basin::most_dimensions),
                              "box that they are drawn from, key by key")});
  return any_of({map_of({must("kind", word({"map"}), "map")}), std::move(scan), std::move(samples)});
}

Form output_form() {
  return map_of(
      joined({{must("directory", text(), "directory of the results; --output goes first")},
              newer({may("warn_over_clearances", number(model::positive),
                         "motions beyond so many clearances of the first stop are counted and warned of",
                         shortest(RunConfig{}.warn_over_clearances))})}));
}

}  // namespace

Key base_of_map() {
  Key base =
      may("base", text(), "file that this map is written over, relative to the one it stands in", "(none)");
  base.since = "0.1.0+";
  return base;
}

std::vector<Key> caption_keys() {
  return newer({may("title", text(200), "what the results are called where they are shown", "(none)"),
                may("author", text(200), "who made them", "(none)"),
                may("note", text(), "anything else, of several lines where needed", "(none)")});
}

Form run_form() {
  Key study = may("study", study_form(), "what is asked of every cell besides its motion", "(a map)");
  study.since = "0.1.0+";
  return map_of(
      joined({caption_keys(),
              {base_of_map(), must("rotor", rotor_form(), "the rotor"),
               must("stops", stops_form(), "places where it can touch; the whirl ratio refers to the first"),
               may("kick", kick_form(), "half-sine pulse that starts a run", "(none)"),
               may("start", start_form(), "state in which every run begins, instead of a kick", "(none)"),
               may("gravity_m_per_s2", number(model::not_negative),
                   "acceleration along -y; clearances count from the unloaded position", "0"),
               must("sweep", sweep_form(), "cells of the map: speeds, unbalances and other axes"),
               std::move(study), may("solver", solver_form(), "how motions are computed"),
               may("response", response_form(), "how long runs are and what is looked for in them"),
               must("output", output_form(), "where results go")}}),
      {{{{{"kick"}, {}}, {{"start"}, {}}}, true}});
}

}  // namespace rubsweep::config::keys
