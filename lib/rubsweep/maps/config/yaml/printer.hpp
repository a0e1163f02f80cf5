#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::yaml {

/// Writes YAML in block style, two spaces a level, with the shortest doubles that read back the same.
/// yaml-cpp's emitter has the same layout, but it writes the byte 0x7f, which is forbidden in YAML files,
/// unescaped. For bytes that are not UTF-8 it writes U+FFFD instead of throwing an error.
class Printer {
 public:
  void number(std::string_view name, double value);
  void numbers(std::string_view name, std::span<const double> values);  ///< list in flow style, on one line
  void texts(std::string_view name, std::span<const std::string> values);  ///< a list; throws as text() does
  void integer(std::string_view name, long value);
  void word(std::string_view name, std::string_view value);

  /// Prints a text without quotes where it then reads back as the same text, otherwise in double quotes.
  /// Throws ConfigError where `value` is not UTF-8, as no YAML file can hold it.
  void text(std::string_view name, std::string_view value);

  /// Prints lines of plain text as a block; the last line ends with a line end, too.
  void block(std::string_view name, std::string_view lines);

  void open(std::string_view name);  ///< begins a map or a list; close() ends it
  void open_item();                  ///< begins a map as the next item of a list; close() ends it
  void close();

  /// Overloads have the same names as in Section, so that one list of fields serves reader and printer.
  void field(std::string_view name, double value, const model::Range&) { number(name, value); }
  void field(std::string_view name, const std::optional<double>& value, const model::Range& range);
  template <std::signed_integral Integer>
  void field(std::string_view name, Integer value, const IntegerRange&) {
    integer(name, value);
  }
  template <class Enum, std::size_t count>
  void field(std::string_view name, Enum value, const Words<Enum, count>& words) {
    for (std::size_t i = 0; i < words.values.size(); ++i) {
      if (words.values[i] == value) word(name, words.texts[i]);
    }
  }

  void field(std::string_view name, const std::optional<int>& value, const model::IntegerOr& range);
  void field(std::string_view name, const std::vector<double>& values, const model::NumberOrList&) {
    numbers(name, values);
  }
  template <class Visit>
  void map(std::string_view name, std::string_view /*meaning*/, Visit&& visit) {
    open(name);
    visit(*this);
    close();
  }
  template <class Visit>
  void beside(std::string_view, std::initializer_list<std::string>, bool holds, Visit&& visit) {
    if (holds) visit();
  }

  const std::string& yaml() const { return yaml_; }

 private:
  void line(std::string_view name, std::string_view value);

  std::string yaml_;
  std::size_t depth_ = 0;
  bool item_begins_ = false;
};

/// Prints every field that the struct's own list names.
template <class Struct>
void print_fields(Printer& printer, const Struct& source) {
  Struct::visit_fields(source, model::fields_into(printer));
}

/// Prints these fields as a map of its own.
template <class Struct>
void print_map(Printer& printer, std::string_view name, const Struct& source) {
  printer.open(name);
  print_fields(printer, source);
  printer.close();
}

}  // namespace rubsweep::config::yaml
