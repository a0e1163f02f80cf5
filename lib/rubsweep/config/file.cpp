#include "rubsweep/config/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "rubsweep/config/base.hpp"
#include "rubsweep/config/override.hpp"
#include "rubsweep/config/support_table.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::config {

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

void refuse_foreign(const Node& root, std::initializer_list<std::string_view> theirs,
                    std::initializer_list<std::string_view> ours, std::string_view program,
                    Diagnostics& diagnostics) {
  const auto among = [](const Node::Key& key, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, key.text) != names.end();
  };
  if (std::ranges::any_of(root.keys, [&](const Node::Key& key) { return among(key, ours); })) return;
  for (const Node::Key& key : root.keys) {
    if (!among(key, theirs)) continue;
    diagnostics.add(key.place, key.text, fmt::format("belongs to a configuration of {}", program),
                    fmt::format("{} with this file", program));
    diagnostics.throw_if_any();
  }
}

Node parse_config(std::string_view text, const std::filesystem::path& file, std::string_view form,
                  const std::vector<std::string>& overrides, Diagnostics& diagnostics) {
  auto root = parse_document(text, -1, "", diagnostics);
  diagnostics.throw_if_any();
  if (root->kind == Node::Kind::null) {
    diagnostics.add(SourcePosition{}, "", "the configuration is empty", form);
    diagnostics.throw_if_any();
  }
  if (!resolve_bases(*root, file, diagnostics)) diagnostics.throw_if_any();
  apply_overrides(*root, overrides, diagnostics);
  refuse_base_of_override(*root, diagnostics);
  resolve_tables(*root, diagnostics);
  return *std::move(root);
}

}  // namespace rubsweep::config
