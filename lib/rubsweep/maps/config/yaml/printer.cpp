#include "rubsweep/maps/config/yaml/printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

bool reads_back_plain(std::string_view value) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_safe = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '/'; };
  const auto is_inner = [&](char c) { return is_safe(c) || c == '.' || c == '-'; };
  if (value.empty() || !is_safe(value.front())) return false;
  if (value == "null" || value == "Null" || value == "NULL") return false;
  return std::all_of(value.begin(), value.end(), is_inner);
}

std::string in_quotes(std::string_view name, std::string_view value) {
  std::string quoted = "\"";
  for (std::size_t i = 0; i < value.size();) {
    const std::size_t length = utf8_length(value.substr(i));
    if (length == 0) {
      throw ConfigError(fmt::format("{}: '{}' cannot be written, allowed: UTF-8 text", name, shown(value)));
    }
    if (value[i] == '\n') {
      quoted += "\\n";
    } else if (is_control(value[i])) {
      quoted += fmt::format("\\x{:02x}", static_cast<unsigned char>(value[i]));
    } else {
      if (value[i] == '"' || value[i] == '\\') quoted += '\\';
      quoted += value.substr(i, length);
    }
    i += length;
  }
  return quoted + '"';
}

}  // namespace

void Printer::line(std::string_view name, std::string_view value) {
  const std::size_t indent = 2 * depth_ - (item_begins_ ? 2 : 0);
  yaml_ += fmt::format("{:{}}{}{}:{}{}\n", "", indent, item_begins_ ? "- " : "", name,
                       value.empty() ? "" : " ", value);
  item_begins_ = false;
}

void Printer::number(std::string_view name, double value) { line(name, fmt::format("{}", value)); }

void Printer::numbers(std::string_view name, std::span<const double> values) {
  line(name, fmt::format("[{}]", fmt::join(values, ", ")));
}

void Printer::field(std::string_view name, const std::optional<double>& value, const model::Range&) {
  if (value) number(name, *value);
}

void Printer::field(std::string_view name, const std::optional<int>& value, const model::IntegerOr& range) {
  value ? integer(name, *value) : word(name, range.word);
}

void Printer::integer(std::string_view name, long value) { line(name, fmt::format("{}", value)); }

void Printer::word(std::string_view name, std::string_view value) { line(name, value); }

void Printer::text(std::string_view name, std::string_view value) {
  line(name, reads_back_plain(value) ? std::string(value) : in_quotes(name, value));
}

void Printer::texts(std::string_view name, std::span<const std::string> values) {
  std::string list;
  for (const std::string& value : values) {
    list += list.empty() ? "" : ", ";
    list += reads_back_plain(value) ? value : in_quotes(name, value);
  }
  line(name, "[" + list + "]");
}

void Printer::block(std::string_view name, std::string_view lines) {
  line(name, "|");
  const std::string indent(2 * depth_ + 2, ' ');
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    yaml_ += indent;
    yaml_ += lines.substr(0, end);
    yaml_ += '\n';
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
}

void Printer::open(std::string_view name) {
  line(name, "");
  ++depth_;
}

void Printer::open_item() {
  ++depth_;
  item_begins_ = true;
}

void Printer::close() { --depth_; }

}  // namespace rubsweep::config::yaml
