#include "shared/place_arguments.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <variant>

#include "rubsweep/core/model/balance.hpp"
#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/maps/config/study/sweep.hpp"
#include "rubsweep/maps/config/unit_slips.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

void refuse_two_of(const po::variables_map& given, std::initializer_list<const char*> names) {
  const char* first = nullptr;
  for (const char* name : names) {
    if (given.count(name) == 0) continue;
    if (first != nullptr) throw UsageError(fmt::format("--{} and --{} exclude each other", first, name));
    first = name;
  }
}

}  // namespace

void add_place(po::options_description& options) {
  options.add_options()("speed-hz", po::value<double>()->value_name("S"), "shaft speed")(
      "speed-rpm", po::value<double>()->value_name("N"), "the same in revolutions per minute")(
      "whirl-ratio", po::value<double>()->value_name("U"),
      "unbalance, said by the quiet motion: its largest excursion / remaining clearance at the first stop")(
      "eccentricity-m", po::value<double>()->value_name("E"),
      "unbalance, said by the eccentricity of the disc")(
      "unbalance-g-mm", po::value<double>()->value_name("G"), "unbalance, said as such, in g mm");
}

PlaceArguments read_place(const po::variables_map& given) {
  refuse_two_of(given, {"speed-hz", "speed-rpm"});
  refuse_two_of(given, {"whirl-ratio", "eccentricity-m", "unbalance-g-mm"});
  PlaceArguments place{.speed_hz = positive_number(given, "speed-hz")};
  if (const auto rpm = positive_number(given, "speed-rpm")) {
    place.speed_hz = *rpm / model::rpm_per_hz;
    place.by_minutes = true;
  }
  if (const auto ratio = not_negative_number(given, "whirl-ratio"))
    place.unbalance = scene::WhirlRatio{*ratio};
  if (const auto eccentricity_m = not_negative_number(given, "eccentricity-m"))
    place.unbalance = scene::Eccentricity{*eccentricity_m};
  place.unbalance_g_mm = not_negative_number(given, "unbalance-g-mm");
  return place;
}

scene::Unbalance unbalance_of(const PlaceArguments& place, const model::Machine& machine) {
  if (!place.unbalance_g_mm) return place.unbalance.value();
  const double units = model::g_mm_per_metre(machine);
  if (!(units > 0))
    throw UsageError("--unbalance-g-mm: no disc of the rotor stands off the axis, allowed: --whirl-ratio U");
  return scene::Eccentricity{*place.unbalance_g_mm / units};
}

void keep_units(const PlaceArguments& place, sweep::Study& study) {
  if (place.by_minutes) study.grid.written_speed = config::study::in_rpm();
  if (place.unbalance_g_mm)
    study.grid.written_unbalance = config::study::in_g_mm(model::g_mm_per_metre(study.machine));
}

void require_speed(std::string_view option, double speed_hz, const model::Machine& machine) {
  if (!(speed_hz <= model::physical::frequency_hz.high)) {
    throw UsageError(fmt::format("{}: {} Hz is no speed of a shaft, allowed: at most {} Hz", option, speed_hz,
                                 model::physical::frequency_hz.high));
  }
  const auto slip = config::slip_of(config::Quantity::speed_hz, speed_hz, &machine);
  if (slip && slip->certain)
    throw UsageError(fmt::format("{}: {}, allowed: {} Hz", option, slip->wrong, slip->allowed));
  if (const model::RotorKit* kit = model::kit_of(machine)) {
    const model::Range reached = model::table_speeds_hz(*kit);
    if (!model::contains(reached, speed_hz))
      throw UsageError(fmt::format("{}: the tables of the supports do not reach {}, allowed: speeds from {}",
                                   option, model::speed_text(speed_hz),
                                   model::speed_range_text(reached.low, reached.high)));
  }
}

void ask_about(std::string_view program, const scene::Unbalance& unbalance, const model::Machine& machine,
               bool quiet) {
  const auto slip = std::visit(
      overloaded{[&](const scene::WhirlRatio& ratio) {
                   return config::slip_of(config::Quantity::whirl_ratio, ratio.value, &machine);
                 },
                 [&](const scene::Eccentricity& eccentricity) {
                   return config::slip_of(config::Quantity::eccentricity_m, eccentricity.value_m, &machine);
                 }},
      unbalance);
  if (slip) ask(program, {"the unbalance: " + slip->wrong}, quiet);
}

}  // namespace rubsweep::apps
