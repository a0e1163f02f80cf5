#include "rubsweep/maps/config/study/captions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::study {
namespace {

constexpr std::size_t longest_line = 200;

struct Caption {
  std::string_view name;
  std::string batch::Captions::*text;
  std::size_t longest;
  bool many_lines;
  std::string_view meaning;
};
constexpr std::array captions_there_are{
    Caption{"title", &batch::Captions::title, longest_line, false,
            "what the results are called where they are shown"},
    Caption{"author", &batch::Captions::author, longest_line, false, "who made them"},
    Caption{"note", &batch::Captions::note, yaml::max_text_bytes, true,
            "anything else, of several lines where needed"}};

/// The first character that is not shown as it is, escaped; empty without one.
std::string hidden_in(std::string_view text, bool many_lines) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = std::max<std::size_t>(yaml::utf8_length(text.substr(i)), 1);
    const std::string_view character = text.substr(i, length);
    if (yaml::is_hidden(character) && !(many_lines && character == "\n")) return yaml::escaped(character);
    i += length;
  }
  return "";
}

}  // namespace

void read_captions(yaml::Section& root, batch::Captions& captions) {
  for (const Caption& caption : captions_there_are) {
    const auto value = root.find(caption.name);
    if (!value) continue;
    auto text = read_text(*value);
    if (!text) continue;
    const std::string_view allowed =
        caption.many_lines ? "UTF-8 text and line ends" : "UTF-8 text of one line";
    if (const std::string hidden = hidden_in(*text, caption.many_lines); !hidden.empty()) {
      refuse(*value, fmt::format("holds the character {}, which cannot be shown", hidden), allowed);
    } else if (text->size() > caption.longest) {
      refuse(*value, "is too long", fmt::format("at most {} bytes", caption.longest));
    } else {
      captions.*caption.text = *std::move(text);
    }
  }
}

std::vector<keys::Key> caption_keys() {
  std::vector<keys::Key> keys;
  for (const Caption& caption : captions_there_are)
    keys.push_back(keys::may(std::string(caption.name), keys::text(caption.longest),
                             std::string(caption.meaning), "(none)"));
  return newer(std::move(keys));
}

void print_captions(yaml::Printer& printer, const batch::Captions& captions) {
  for (const Caption& caption : captions_there_are) {
    const std::string& text = captions.*caption.text;
    if (!text.empty()) printer.text(caption.name, text);
  }
}

}  // namespace rubsweep::config::study
