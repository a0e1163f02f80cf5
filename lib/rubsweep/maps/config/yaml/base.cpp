#include "rubsweep/maps/config/yaml/base.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::yaml {
namespace {

bool is_of_another_kind(const Node& base, const Node& over) {
  const Node *in_base = entry(base, "kind"), *in_over = entry(over, "kind");
  return in_base != nullptr && in_over != nullptr && in_base->text != in_over->text;
}

void write_over(Node& base, Node::Key key, Node item, std::string_view path, const Alternatives& alternatives,
                Diagnostics& diagnostics) {
  if (Node* found = entry(base, key.text)) {
    *found =
        merged(std::move(*found), std::move(item), child_path(path, key.text), alternatives, diagnostics);
    base.keys[static_cast<std::size_t>(found - base.items.data())] = std::move(key);
  } else {
    base.keys.push_back(std::move(key));
    base.items.push_back(std::move(item));
  }
}

/// A key of `over` without a value removes the same key of `base`, before alternative keys are removed.
void take_back(Node& base, Node& over) {
  for (std::size_t i = over.keys.size(); i-- > 0;) {
    const Node* found = entry(base, over.keys[i].text);
    if (over.items[i].kind != Node::Kind::null || found == nullptr) continue;
    drop_entry(base, static_cast<std::size_t>(found - base.items.data()));
    drop_entry(over, i);
  }
}

namespace fs = std::filesystem;

constexpr std::string_view allowed_base = "a file to read, named relative to this one";

/// Identity of a file, the same for all of its names.
fs::path identity(const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::weakly_canonical(file, error);
  return error ? file : absolute;
}

bool is_something_else_than_a_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return !error && fs::exists(status) && !fs::is_regular_file(status);
}

class Resolver {
 public:
  Resolver(const Alternatives& alternatives, Diagnostics& diagnostics)
      : alternatives_(alternatives), diagnostics_(diagnostics) {}

  /// `chain`: identities of the files from the root to `file`; each file names the next one as its base.
  void resolve(Node& node, const std::string& path, const fs::path& file, std::vector<fs::path>& chain) {
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const std::string name = node.kind == Node::Kind::map ? node.keys[i].text : std::to_string(i);
      if (name != base_key) resolve(node.items[i], child_path(path, name), file, chain);
    }
    if (auto name = take_base(node, path)) {
      auto base = read({*name, child_path(path, base_key), diagnostics_}, path, file, chain);
      all_read_ = all_read_ && base;
      if (base) node = merged(*std::move(base), std::move(node), path, alternatives_, diagnostics_);
    }
  }

  /// False where a base could not be read.
  bool all_read() const { return all_read_; }

 private:
  /// Removes the key `base` from a map and returns its value; empty where there is none.
  std::optional<Node> take_base(Node& node, const std::string& path) {
    if (entry(node, base_key) == nullptr) return std::nullopt;
    refuse_repeated_keys(node, path, diagnostics_);
    drop_repeated_keys(node);
    Node* found = entry(node, base_key);
    Node name = std::move(*found);
    drop_entry(node, static_cast<std::size_t>(found - node.items.data()));
    return name;
  }

  /// Content of the file named by `name`, with its own bases resolved; empty after a problem was added.
  std::optional<Node> read(const Value& name, const std::string& path, const fs::path& file,
                           std::vector<fs::path>& chain) {
    const auto text = read_text(name);
    if (!text) return std::nullopt;
    const fs::path base = file.parent_path() / *text;
    if (!may_be_read(name, base, chain)) return std::nullopt;
    const FileBytes bytes = read_bytes(base);
    if (!bytes.problem.empty())
      return refuse(name, fmt::format("'{}' cannot be read: {}", shown(*text), bytes.problem), allowed_base);
    const int index = diagnostics_.add_file(shown(base.string(), max_text_bytes));
    auto node = parse_document(bytes.text, -1, path, diagnostics_, index);
    if (!node || !is_map(*node, path) || !counts(name, *node)) return std::nullopt;
    chain.push_back(identity(base));
    resolve(*node, path, base, chain);
    chain.pop_back();
    return node;
  }

  bool may_be_read(const Value& name, const fs::path& base, const std::vector<fs::path>& chain) {
    const std::string text = shown(name.node.text);
    if (is_something_else_than_a_file(base)) {
      refuse(name, fmt::format("'{}' is not a file", text), allowed_base);
    } else if (std::find(chain.begin(), chain.end(), identity(base)) != chain.end()) {
      refuse(name, fmt::format("'{}' leads back to itself", text), "a file that is not based on this one");
    } else if (chain.size() > static_cast<std::size_t>(max_base_generations)) {
      refuse(name, "too many bases of bases", fmt::format("at most {}", max_base_generations));
    } else if (++files_ > max_base_files) {
      // The problem is reported only once, for the first base above the limit.
      if (files_ == max_base_files + 1)
        refuse(name, "too many bases", fmt::format("at most {} in all", max_base_files));
    } else {
      return true;
    }
    return false;
  }

  bool is_map(const Node& node, const std::string& path) {
    if (node.kind == Node::Kind::map) return true;
    const std::string found = node.kind == Node::Kind::null ? "the file is empty" : describe(node);
    const SourcePosition top{-1, 1, 1,
                             node.place.file};  // an empty file has no useful place after its last line
    diagnostics_.add(node.kind == Node::Kind::null ? top : node.place, path, found + " and no base", "a map");
    return false;
  }

  bool counts(const Value& name, const Node& node) {
    nodes_ += count_nodes(node);
    if (nodes_ <= max_document_nodes) return true;
    refuse(name, "too many values", fmt::format("at most {} in all bases", max_document_nodes));
    return false;
  }

  const Alternatives& alternatives_;
  Diagnostics& diagnostics_;
  bool all_read_ = true;
  int files_ = 0;
  std::size_t nodes_ = 0;
};

}  // namespace

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

Node merged(Node base, Node over, std::string_view path, const Alternatives& alternatives,
            Diagnostics& diagnostics) {
  if (base.kind != Node::Kind::map || over.kind != Node::Kind::map || is_of_another_kind(base, over)) {
    return over;
  }
  for (Node* map : {&base, &over}) {
    refuse_repeated_keys(*map, path, diagnostics);
    drop_repeated_keys(*map);
  }
  base.place = over.place;
  take_back(base, over);
  for (const Node::Key& key : over.keys) alternatives.drop(base, key.text);
  for (std::size_t i = 0; i < over.keys.size(); ++i) {
    write_over(base, std::move(over.keys[i]), std::move(over.items[i]), path, alternatives, diagnostics);
  }
  return base;
}

bool resolve_bases(Node& root, const fs::path& file, const Alternatives& alternatives,
                   Diagnostics& diagnostics) {
  std::vector<fs::path> chain{identity(file)};
  Resolver resolver(alternatives, diagnostics);
  resolver.resolve(root, "", file, chain);
  return resolver.all_read();
}

void refuse_base_of_override(const Node& root, Diagnostics& diagnostics) {
  for (const Node::Key& key : root.keys)
    if (key.text == base_key)
      diagnostics.add(key.place, base_key, "an override is no file and has no base",
                      "a base named in a file");
}

}  // namespace rubsweep::config::yaml
