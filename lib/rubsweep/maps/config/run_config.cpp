#include "rubsweep/maps/config/run_config.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "rubsweep/core/contact/restitution.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/structure/matrix_shaft.hpp"
#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/study/study.hpp"
#include "rubsweep/maps/config/unit_slips.hpp"
#include "rubsweep/maps/config/varied_study.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config {
namespace {

constexpr std::string_view root_form = "a map with rotor, stops, sweep, output";

RunConfig read_sections(const yaml::Value& root) {
  yaml::Section section(root, root_form);
  section.find(yaml::base_key);  // resolved before; known here so that a misspelt key can be compared with it
  RunConfig config;
  config.study = study::read_study(section);
  if (const auto value = section.require("output", "a map")) read_run_output(*value, config);
  read_captions(section, config.captions);
  return config;
}

/// A question and the key that it is about.
struct Question {
  std::string key, text;
};

const model::JeffcottRotor* jeffcott(const sweep::Study& study) {
  return std::get_if<model::JeffcottRotor>(&study.machine.rotor);
}

/// Unit in which slow speeds were probably given: multiples of the natural frequency, or Hz instead of rpm.
std::string_view unit_of_slow_speeds(double fastest_hz, double natural_hz) {
  if (fastest_hz >= 0.5 && fastest_hz <= 20) return " (multiples of it?)";
  const double by_minute = natural_hz / model::rpm_per_hz;
  if (fastest_hz >= 0.5 * by_minute) return " (rotor.natural_frequency_hz in revolutions per minute?)";
  return "";
}

std::optional<Question> slow_speeds(const yaml::Node& root, const sweep::Study& study) {
  const auto* rotor = jeffcott(study);
  if (rotor == nullptr) return std::nullopt;
  constexpr double slow = 0.1;
  const double fastest_hz = std::ranges::max(study.grid.speed_hz), natural_hz = rotor->natural_frequency_hz;
  if (fastest_hz >= slow * natural_hz) return std::nullopt;
  const bool rpm = find_node(root, "sweep.speed_rpm") != nullptr;
  return Question{
      rpm ? "sweep.speed_rpm" : "sweep.speed_hz",
      fmt::format("no speed is above {}, less than a tenth of the natural frequency{}",
                  model::speed_text(fastest_hz, 4), rpm ? "" : unit_of_slow_speeds(fastest_hz, natural_hz))};
}

std::optional<Question> idle_kick(const sweep::Study& study) {
  if (!study.machine.kick || study.grid.measure != sweep::UnbalanceMeasure::whirl_ratio) return std::nullopt;
  if (!(std::ranges::min(study.grid.unbalance) >= 1)) return std::nullopt;
  return Question{
      "sweep.whirl_ratio",
      "the quiet whirl reaches the wall in every cell, so that the kick is never used (ratios below "
      "1?)"};
}

/// The clearance is measured from the position without weight. A start that lies on the stop is intended.
std::optional<Question> sag_onto_stop(const sweep::Study& study) {
  const auto* rotor = jeffcott(study);
  const double gravity = study.machine.gravity_m_per_s2;
  if (rotor == nullptr || gravity == 0) return std::nullopt;
  const double sag_m = gravity / std::pow(2 * std::numbers::pi * rotor->natural_frequency_hz, 2);
  const Eigen::Vector2d down(0, -sag_m);
  const auto touches = [](const model::Stop& stop, const Eigen::Vector2d& at_m) {
    const contact::Wall wall = contact::wall_of(stop.geometry);
    return contact::penetration_at(wall, at_m + contact::offset(wall), stop.clearance_m) >= 0;
  };
  const auto given_m = [](const model::Start& start) {
    return Eigen::Vector2d(start.rotor.x_m.value_or(0), start.rotor.y_m.value_or(0));
  };
  const auto& start = study.machine.start;
  for (std::size_t i = 0; i < study.machine.stops.size(); ++i) {
    const model::Stop& stop = study.machine.stops[i];
    if (!touches(stop, down) || (start && touches(stop, given_m(*start)))) continue;
    return Question{
        "gravity_m_per_s2",
        fmt::format("the rotor sags by {:.3g} m and rests on stop {}{}, whose clearance counts from the "
                    "position without weight (leave gravity out, and count from the sag?)",
                    sag_m, i, model::in_brackets(model::name_at(study.stop_names, i)))};
  }
  return std::nullopt;
}

void add_restitutions(const sweep::Study& study, std::vector<Question>& questions) {
  for (std::size_t i = 0; i < study.machine.stops.size(); ++i) {
    const auto* nominal = std::get_if<model::NominalRestitution>(&study.machine.stops[i].damping);
    const double least = model::DeliveredRestitution::range.low;
    if (nominal == nullptr || nominal->value >= least) continue;
    const double ratio = contact::nominal_damping_ratio(nominal->value);
    questions.push_back(
        {fmt::format("stops.{}.restitution", i),
         fmt::format("{} is nominal, and an impact returns {:.2g} of its speed: this law returns at least {} "
                     "(restitution_delivered?)",
                     nominal->value, contact::delivered_restitution(ratio), least)});
    return;  // only the first of equal questions
  }
}

/// Questions about numbers that are each plausible but odd together: all speeds far below the natural
/// frequency of a Jeffcott rotor, a kick that no cell uses because each begins in contact, a rotor that sags
/// onto a stop, a nominal restitution that no impact reaches. `root`: the configuration from which `study`
/// was read without a problem. Each question has the form that unit_questions describes.
std::vector<std::string> plan_questions(const yaml::Value& root, const sweep::Study& study) {
  std::vector<Question> asked;
  for (auto& question : {slow_speeds(root.node, study), idle_kick(study), sag_onto_stop(study)}) {
    if (question) asked.push_back(*question);
  }
  add_restitutions(study, asked);
  std::vector<std::string> questions;
  for (const auto& [key, text] : asked) {
    // A value that comes from a default or an axis has no place in the file.
    if (const yaml::Node* node = find_node(root.node, key))
      questions.push_back(fmt::format("{}: {}: {}", root.diagnostics.describe(node->place), key, text));
  }
  return questions;
}

std::vector<std::string> varied_keys(const sweep::Study& study) {
  std::vector<std::string> keys = sweep::key_names(study.grid);
  if (study.threshold)
    keys.insert(keys.end(), study.threshold->axis.keys.begin(), study.threshold->axis.keys.end());
  if (study.basin) {
    for (const sweep::DrawnKey& drawn : study.basin->over) keys.push_back(drawn.key);
  }
  return keys;
}

}  // namespace

keys::Form run_form() {
  return keys::map_of(keys::joined({caption_keys(),
                                    {base_of_map()},
                                    study::study_keys(),
                                    {keys::must("output", run_output_form(), "where results go")}}),
                      {study::kick_or_start()});
}

const yaml::Alternatives& run_alternatives() {
  static const yaml::Alternatives all(run_form());
  return all;
}

model::Machine read_machine_text(std::string_view text, const std::string& name,
                                 const std::vector<std::string>& overrides) {
  return read_parsed(
      text, name, root_form, overrides,
      [](const yaml::Value& root) { return read_sections(root).study.machine; }, run_alternatives());
}

RunConfig read_run_config(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return read_run_config_text(yaml::read_config_bytes(file), file.string(), overrides);
}

RunConfig read_run_config_text(std::string_view text, const std::string& name,
                               const std::vector<std::string>& overrides) {
  yaml::Diagnostics diagnostics(name, overrides);
  const yaml::Node root = parse_config(text, name, root_form, overrides, diagnostics, run_alternatives());
  refuse_foreign(root, {"ring", "loads"}, {"rotor", "stops"}, "ringstab", diagnostics);
  RunConfig config = read_sections({root, "", diagnostics});
  if (diagnostics.count() == 0) refuse_unit_slips({root, "", diagnostics}, &config.study.machine);
  if (diagnostics.count() == 0) vary_keys({root, "", diagnostics}, config.study);
  diagnostics.throw_if_any();
  config.questions = unit_questions({root, "", diagnostics}, &config.study.machine);
  // If there is a question about units, other oddities follow from the same slip and are not mentioned.
  if (config.questions.empty()) config.questions = plan_questions({root, "", diagnostics}, config.study);
  return config;
}

std::string print_config(const RunConfig& config, machine::MatrixPrint matrices) {
  yaml::Printer printer;
  print_captions(printer, config.captions);
  study::print_study(printer, config.study, study::AxisPrint::as_written, matrices);
  print_run_output(printer, config);
  return printer.yaml();
}

std::string print_study(const sweep::Study& study) {
  yaml::Printer printer;
  study::print_study(printer, study, study::AxisPrint::by_value);
  return printer.yaml();
}

std::map<std::string_view, std::string> exported_matrices(const RunConfig& config) {
  RunConfig exported = config;
  exported.study.machine = structure::machine_by_matrices(config.study.machine);
  for (const std::string& key : varied_keys(config.study)) {
    if (key.starts_with("rotor."))
      throw ConfigError(fmt::format(
          "{}: is varied, and matrices are of one rotor, allowed: keys of other parts of the machine", key));
  }
  exported.output_directory = batch::directory_beside(config.output_directory, "_matrices");
  auto files = machine::matrix_files(*model::kit_of(exported.study.machine)->matrices);
  files["rotor.yaml"] = print_config(exported, machine::MatrixPrint::as_files);
  return files;
}

std::string digest_of(std::string_view text) {
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  return boost::uuids::to_string(generator(std::string(text)));
}

std::string study_digest(const sweep::Study& study) { return digest_of(print_study(study)); }

}  // namespace rubsweep::config
