#include "rubsweep/maps/config/yaml/file_bytes.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

FileBytes read_bytes(const std::filesystem::path& file, batch::InputKind kind) {
  const batch::Input input = batch::find_input(file, kind);
  if (!input.problem.empty()) return {"", input.problem};
  FileBytes bytes;
  if (const int error = batch::read_bytes(input.descriptor.get(), max_document_bytes + 1, bytes.text))
    return {"", std::generic_category().message(error)};
  return bytes;
}

std::string read_config_bytes(const std::filesystem::path& file) {
  FileBytes bytes = read_bytes(file, batch::InputKind::also_passed_on);
  if (!bytes.problem.empty())
    throw IoError(fmt::format("{}: cannot be read: {}", file.string(), bytes.problem));
  return std::move(bytes.text);
}

}  // namespace rubsweep::config::yaml
