#include "rubsweep/config/yaml/merge.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "rubsweep/config/yaml/alternatives.hpp"
#include "rubsweep/config/yaml/repeated_keys.hpp"
#include "rubsweep/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

/// Index of a key, or how many there are.
std::size_t index_of(const Node& map, std::string_view name) {
  const auto found =
      std::find_if(map.keys.begin(), map.keys.end(), [&](const Node::Key& key) { return key.text == name; });
  return static_cast<std::size_t>(found - map.keys.begin());
}

bool is_of_another_kind(const Node& base, const Node& over) {
  const std::size_t in_base = index_of(base, "kind"), in_over = index_of(over, "kind");
  return in_base < base.keys.size() && in_over < over.keys.size() &&
         base.items[in_base].text != over.items[in_over].text;
}

void write_over(Node& base, Node::Key key, Node item, std::string_view path, Diagnostics& diagnostics) {
  const std::size_t index = index_of(base, key.text);
  if (index == base.keys.size()) {
    base.keys.push_back(std::move(key));
    base.items.push_back(std::move(item));
  } else {
    base.items[index] =
        merged(std::move(base.items[index]), std::move(item), child_path(path, key.text), diagnostics);
    base.keys[index] = std::move(key);
  }
}

/// Lets a key without a value take back the base's own, before alternative keys do.
void take_back(Node& base, Node& over) {
  for (std::size_t i = over.keys.size(); i-- > 0;) {
    const std::size_t index = index_of(base, over.keys[i].text);
    if (over.items[i].kind != Node::Kind::null || index == base.keys.size()) continue;
    drop_entry(base, index);
    drop_entry(over, i);
  }
}

}  // namespace

Node merged(Node base, Node over, std::string_view path, Diagnostics& diagnostics) {
  if (base.kind != Node::Kind::map || over.kind != Node::Kind::map || is_of_another_kind(base, over)) {
    return over;
  }
  for (Node* map : {&base, &over}) {
    refuse_repeated_keys(*map, path, diagnostics);
    drop_repeated_keys(*map);
  }
  base.place = over.place;
  take_back(base, over);
  for (const Node::Key& key : over.keys) drop_alternatives(base, key.text);
  for (std::size_t i = 0; i < over.keys.size(); ++i) {
    write_over(base, std::move(over.keys[i]), std::move(over.items[i]), path, diagnostics);
  }
  return base;
}

}  // namespace rubsweep::config::yaml
