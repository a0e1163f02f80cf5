#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/yaml/diagnostics.hpp"

namespace rubsweep::config::yaml {

/// One value of a YAML document and the place where it was written. An alias is already a copy of its anchor.
struct Node {
  enum class Kind { null, scalar, list, map };

  struct Key {
    std::string text;
    SourcePosition place;
  };

  Kind kind = Kind::null;
  SourcePosition place;       ///< place of the value; for null in a map, place of its key
  std::string text{};         ///< text of a scalar
  bool quoted = false;        ///< true for a scalar in quotes or a block: text, never a number
  std::vector<Key> keys{};    ///< keys of a map as written, with repeated ones; keys[i] belongs to items[i]
  std::vector<Node> items{};  ///< values of a list or a map
};

/// Limits that keep time and memory small for any input, even a hostile one.
inline constexpr std::size_t max_document_bytes = 16'000'000;
inline constexpr std::size_t max_document_depth = 32;
inline constexpr std::size_t max_document_nodes = 100'000;

/// Parses one YAML document. An empty text is a null node. Anything that is not plain data is refused: tags,
/// several documents, keys that are not scalars, aliases of an enclosing node, more than the limits above.
/// The problem then goes to `diagnostics` under `path`, and the result is empty. `override_index` and `file`:
/// see SourcePosition.
std::optional<Node> parse_document(std::string_view text, int override_index, std::string_view path,
                                   Diagnostics& diagnostics, int file = 0);

/// Value under a key of a map; null where the key is missing or the node is no map.
Node* entry(Node& map, std::string_view name);
const Node* entry(const Node& map, std::string_view name);

/// Number of values in a node, itself included.
std::size_t count_nodes(const Node& node);

}  // namespace rubsweep::config::yaml
