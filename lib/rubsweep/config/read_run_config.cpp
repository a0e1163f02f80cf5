#include "rubsweep/config/read_run_config.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "rubsweep/config/diagnostics.hpp"
#include "rubsweep/config/document.hpp"
#include "rubsweep/config/kick.hpp"
#include "rubsweep/config/override.hpp"
#include "rubsweep/config/response.hpp"
#include "rubsweep/config/rotor.hpp"
#include "rubsweep/config/section.hpp"
#include "rubsweep/config/solver.hpp"
#include "rubsweep/config/stop.hpp"
#include "rubsweep/config/sweep.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::config {
namespace {

constexpr std::string_view root_form = "a map with rotor, stops, sweep, output";

std::filesystem::path read_output(const Value& value) {
  Section section(value);
  std::string directory;
  if (const auto text = section.require("directory", "a path")) directory = read_text(*text).value_or("");
  section.refuse_unknown_keys();
  return directory;
}

RunConfig read_sections(const Value& root) {
  Section section(root, root_form);
  RunConfig config;
  sweep::Study& study = config.study;
  if (const auto value = section.require("rotor", "a map")) study.machine.rotor = read_rotor(*value);
  if (const auto value = section.require("stops", "a list of maps")) study.machine.stops = read_stops(*value);
  if (const auto value = section.find("kick")) study.machine.kick = read_kick(*value);
  section.field("gravity_m_per_s2", study.machine.gravity_m_per_s2, model::not_negative);
  if (const auto value = section.require("sweep", "a map")) study.grid = read_sweep(*value);
  if (const auto value = section.find("solver")) study.solver = read_solver(*value);
  if (const auto value = section.find("response")) study.response = read_response(*value);
  if (const auto value = section.require("output", "a map")) config.output_directory = read_output(*value);
  section.refuse_unknown_keys();
  return config;
}

IoError cannot_read(const std::filesystem::path& file) {
  const int cause = errno;
  return IoError(
      fmt::format("{}: cannot be read: {}", file.string(), std::generic_category().message(cause)));
}

/// At most one byte more than a document may have: enough to refuse it as too large.
std::string read_bytes(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw cannot_read(file);
  std::string text(max_document_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw cannot_read(file);
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace

RunConfig read_run_config(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return read_run_config_text(read_bytes(file), file.string(), overrides);
}

RunConfig read_run_config_text(std::string_view text, const std::string& name,
                               const std::vector<std::string>& overrides) {
  Diagnostics diagnostics(name, overrides);
  auto root = parse_document(text, -1, "", diagnostics);
  diagnostics.throw_if_any();
  if (root->kind == Node::Kind::null) {
    diagnostics.add(Place{}, "", "the configuration is empty", root_form);
    diagnostics.throw_if_any();
  }
  apply_overrides(*root, overrides, diagnostics);
  RunConfig config = read_sections({*root, "", diagnostics});
  diagnostics.throw_if_any();
  return config;
}

}  // namespace rubsweep::config
