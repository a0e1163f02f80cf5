#include "rubsweep/config/study/kick.hpp"

#include <fmt/format.h>

#include "rubsweep/config/yaml/section.hpp"

namespace rubsweep::config::study {

model::Kick read_kick(const yaml::Value& value, const std::optional<model::Range>& places) {
  yaml::Section section(value);
  model::Kick kick;
  read_fields(section, kick);
  section.field("angle_deg", kick.angle_deg, model::any_finite);
  section.field("phase_deg", kick.phase_deg, model::any_finite);
  if (places) section.field("position_m", kick.position_m, *places);
  section.refuse_unknown_keys();
  return kick;
}

void refuse_endless_kick(const yaml::Value& value, const model::Kick& kick, double longest_run_s) {
  if (kick.force_n == 0 || kick.duration_s < longest_run_s) return;
  yaml::Section(value).refuse_together(
      "duration_s", {"duration_s"},
      fmt::format("{} s are no shorter than a run, {:.4g} s", kick.duration_s, longest_run_s),
      "less than response.max_revolutions / speed");
}

void print_kick(yaml::Printer& printer, const model::Kick& kick) {
  printer.open("kick");
  print_fields(printer, kick);
  printer.field("angle_deg", kick.angle_deg, model::any_finite);
  printer.field("phase_deg", kick.phase_deg, model::any_finite);
  printer.field("position_m", kick.position_m, model::any_finite);
  printer.close();
}

}  // namespace rubsweep::config::study
