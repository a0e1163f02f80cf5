#include "shared/help_text.hpp"

#include <algorithm>
#include <vector>

namespace rubsweep::apps {
namespace {

/// Number of displayed characters: continuation bytes of UTF-8 do not count.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// Column where the description begins in a table row; in other lines, their indentation.
std::size_t hanging_indent(std::string_view line) {
  const std::size_t begin = indent_of(line), gap = line.find("  ", begin);
  if (begin == 0 || gap == std::string_view::npos) return begin;
  return std::min(line.find_first_not_of(' ', gap), line.size());
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// End of the first word; blanks between single quotes belong to the word.
std::size_t end_of_word(std::string_view text) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\'' && (quoted || i == 0 || text[i - 1] == ' ' || text[i - 1] == '=')) quoted = !quoted;
    if (text[i] == ' ' && !quoted) return i;
  }
  return std::min(text.find(' '), text.size());
}

/// Appends words, separated by single blanks, to `head` and breaks the lines.
std::string filled(std::string_view head, std::string_view words, std::size_t indent, std::size_t columns,
                   std::string_view end_of_line) {
  std::string text, line(head);
  bool begun = false;
  while (!words.empty()) {
    const std::size_t end =
        end_of_line.empty() ? std::min(words.find(' '), words.size()) : end_of_word(words);
    const std::string_view word = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    if (word.empty()) continue;
    const std::size_t room = columns - end_of_line.size();
    if (begun && width_of(line) + 1 + width_of(word) > room) {
      text.append(line).append(end_of_line).append("\n");
      line.assign(indent, ' ');
      begun = false;
    }
    if (begun) line += ' ';
    line += word;
    begun = true;
  }
  return text + line + "\n";
}

/// Whether a line ends with a full stop, with the colon before a list, or with the last option of a usage
/// line.
bool ends_a_paragraph(std::string_view line) {
  return line.ends_with('.') || line.ends_with(':') || line.ends_with(']');
}

/// Number of lines, from `first` on, that form one paragraph.
std::size_t paragraph(const std::vector<std::string_view>& lines, std::size_t first) {
  const std::size_t indent = hanging_indent(lines[first]);
  std::size_t end = first + 1;
  while (end < lines.size() && !lines[end].empty() && indent_of(lines[end]) == indent &&
         (indent == 0 || hanging_indent(lines[end]) == indent) && !ends_a_paragraph(lines[end - 1]))
    ++end;
  return end - first;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t columns) {
  const std::vector<std::string_view> lines = lines_of(text);
  std::string result;
  bool commands = false;
  for (std::size_t i = 0; i < lines.size();) {
    if (lines[i] == "Examples:")
      commands = true;
    else if (lines[i].empty())
      commands = false;
    const std::size_t count = commands || lines[i].empty() ? 1 : paragraph(lines, i);
    const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(i),
               end = begin + static_cast<std::ptrdiff_t>(count);
    if (std::none_of(begin, end, [&](std::string_view line) { return width_of(line) > columns; })) {
      std::for_each(begin, end, [&](std::string_view line) { result.append(line).append("\n"); });
    } else {
      const std::size_t hanging = commands ? indent_of(*begin) : hanging_indent(*begin);
      std::string words;
      std::for_each(begin, end, [&](std::string_view line) {
        words.append(line.substr(std::min(hanging, line.size()))).append(" ");
      });
      result += commands ? filled(begin->substr(0, hanging), words, hanging + 4, columns, " \\")
                         : filled(begin->substr(0, hanging), words, hanging, columns, "");
    }
    i += count;
  }
  return result;
}

}  // namespace rubsweep::apps
