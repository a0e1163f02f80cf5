#include "rubsweep/config/file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "rubsweep/config/override.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::config {
namespace {

IoError cannot_read(const std::filesystem::path& file) {
  const int cause = errno;
  return IoError(
      fmt::format("{}: cannot be read: {}", file.string(), std::generic_category().message(cause)));
}

}  // namespace

std::string read_config_bytes(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw cannot_read(file);
  std::string text(max_document_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw cannot_read(file);
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

Node parse_config(std::string_view text, std::string_view form, const std::vector<std::string>& overrides,
                  Diagnostics& diagnostics) {
  auto root = parse_document(text, -1, "", diagnostics);
  diagnostics.throw_if_any();
  if (root->kind == Node::Kind::null) {
    diagnostics.add(Place{}, "", "the configuration is empty", form);
    diagnostics.throw_if_any();
  }
  apply_overrides(*root, overrides, diagnostics);
  return *std::move(root);
}

}  // namespace rubsweep::config
