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

/// Writes YAML in block style, two spaces a level, shortest doubles that read back the same. Not yaml-cpp's
/// emitter: it lays out the same lines, but leaves the byte 0x7f bare, which no YAML file may hold, and puts
/// U+FFFD for bytes that are not UTF-8 instead of an error.
class Printer {
 public:
  void number(std::string_view name, double value);
  void numbers(std::string_view name, std::span<const double> values);  ///< list in flow style, on one line
  void texts(std::string_view name, std::span<const std::string> values);  ///< such a list; throws as text
  void integer(std::string_view name, long value);
  void word(std::string_view name, std::string_view value);

  /// Plain where that reads back, else in double quotes. Throws ConfigError when `value` is not UTF-8: no
  /// YAML file can hold it.
  void text(std::string_view name, std::string_view value);

  /// Lines of plain text as they are, the last one ended.
  void block(std::string_view name, std::string_view lines);

  void open(std::string_view name);  ///< a map or a list; close() ends it
  void open_item();                  ///< a map as the next item of a list; close() ends it
  void close();

  /// The same names as in Section, so that one list of fields serves both.
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

/// The same as a map of its own.
template <class Struct>
void print_map(Printer& printer, std::string_view name, const Struct& source) {
  printer.open(name);
  print_fields(printer, source);
  printer.close();
}

}  // namespace rubsweep::config::yaml
