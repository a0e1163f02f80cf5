#include "rubsweep/maps/config/machine/matrix_market.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "rubsweep/maps/matlab/read_file.hpp"
#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::config::machine {
namespace {

enum class Layout { coordinate, array };
enum class Symmetry { general, symmetric, skew };

constexpr std::array<std::string_view, 2> layouts{"coordinate", "array"};
constexpr std::array<std::string_view, 2> fields{"real", "integer"};
constexpr std::array<std::string_view, 3> symmetries{"general", "symmetric", "skew-symmetric"};
constexpr std::string_view head_form =
    "%%MatrixMarket matrix, then coordinate or array, real or integer, general, symmetric or skew-symmetric";

struct Problem {
  int line, column;
  std::string wrong, allowed;
};

/// Reads a text line by line into words, without comments and blank lines.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  /// Goes to the next line; false at the end of the text.
  bool next() {
    while (!rest_.empty()) {
      line_ = rest_.substr(0, rest_.find('\n'));
      rest_.remove_prefix(std::min(line_.size() + 1, rest_.size()));
      ++number_;
      split();
      if (!words_.empty() && (words_.front().front() != '%' || number_ == 1)) return true;
    }
    return false;
  }

  const std::vector<std::string_view>& words() const { return words_; }

  [[noreturn]] void refuse(std::string wrong, std::string allowed, std::size_t word = 0) const {
    const auto column = word < words_.size() ? words_[word].data() - line_.data() + 1 : 1;
    throw Problem{std::max(number_, 1), static_cast<int>(column), std::move(wrong), std::move(allowed)};
  }

 private:
  void split() {
    constexpr std::string_view blanks = " \t\r";
    words_.clear();
    for (std::size_t begin = line_.find_first_not_of(blanks); begin < line_.size();) {
      const std::size_t end = std::min(line_.find_first_of(blanks, begin), line_.size());
      words_.push_back(line_.substr(begin, end - begin));
      begin = line_.find_first_not_of(blanks, end);
    }
  }

  std::string_view rest_, line_;
  std::vector<std::string_view> words_;
  int number_ = 0;
};

template <std::size_t count>
std::size_t index_of(const Lines& lines, std::size_t word, const std::array<std::string_view, count>& words) {
  const auto found = std::ranges::find(words, table::in_small_letters(lines.words()[word]));
  if (found == words.end())
    lines.refuse(fmt::format("'{}' is not read", yaml::shown(lines.words()[word])), yaml::describe(words),
                 word);
  return static_cast<std::size_t>(found - words.begin());
}

/// First row of a column that is written.
Eigen::Index first_row(Symmetry symmetry, Eigen::Index column) {
  if (symmetry == Symmetry::general) return 0;
  return symmetry == Symmetry::symmetric ? column : column + 1;
}

class MatrixReader {
 public:
  explicit MatrixReader(std::string_view text) : lines_(text) {}

  Eigen::MatrixXd read() {
    read_head();
    read_size();
    if (layout_ == Layout::coordinate) {
      read_entries();
    } else {
      read_columns();
    }
    return matrix_;
  }

 private:
  void read_head() {
    if (!lines_.next() || table::in_small_letters(lines_.words().front()) != "%%matrixmarket" ||
        lines_.words().size() != 5 || table::in_small_letters(lines_.words()[1]) != "matrix")
      lines_.refuse("does not begin as a Matrix Market file", std::string(head_form));
    layout_ = static_cast<Layout>(index_of(lines_, 2, layouts));
    index_of(lines_, 3, fields);
    symmetry_ = static_cast<Symmetry>(index_of(lines_, 4, symmetries));
  }

  long integer(std::size_t word, long low, long high) const {
    const std::string_view text = lines_.words()[word];
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < low || value > high)
      lines_.refuse(fmt::format("'{}' is no number of a row or column here", yaml::shown(text)),
                    fmt::format("an integer from {} to {}", low, high), word);
    return value;
  }

  double number(std::size_t word) const {
    const std::string_view text = lines_.words()[word];
    const yaml::ParsedNumber number = yaml::parse_number(text);
    if (number.error != yaml::NumberError::none)
      lines_.refuse(fmt::format("'{}' is no finite number", yaml::shown(text)),
                    "a decimal number such as 1.5e6", word);
    return number.value;
  }

  void read_size() {
    const std::size_t wanted = layout_ == Layout::coordinate ? 3 : 2;
    if (!lines_.next() || lines_.words().size() != wanted)
      lines_.refuse("the size is missing",
                    wanted == 3 ? "rows, columns and number of entries" : "rows and columns");
    const auto most = static_cast<long>(model::ShaftMatrices::most_degrees_of_freedom);
    size_ = integer(0, 1, most);
    if (integer(1, 1, most) != size_)
      lines_.refuse(fmt::format("the matrix has {} rows and {} columns", size_, lines_.words()[1]),
                    "as many columns as rows", 1);
    if (wanted == 3) entries_ = integer(2, 0, size_ * size_);
    matrix_.setZero(size_, size_);
  }

  void put(long row, long column, double value) {
    matrix_(row, column) = value;
    if (row == column || symmetry_ == Symmetry::general) return;
    matrix_(column, row) = symmetry_ == Symmetry::skew ? -value : value;
  }

  void read_entries() {
    std::vector<bool> seen(static_cast<std::size_t>(size_ * size_));
    for (long k = 0; k < entries_; ++k) {
      if (!lines_.next())
        lines_.refuse(fmt::format("the matrix ends after {} entries", k),
                      fmt::format("{} entries", entries_));
      if (lines_.words().size() != 3)
        lines_.refuse(fmt::format("the line has {} numbers", lines_.words().size()), "row, column and value");
      const long row = integer(0, 1, size_) - 1, column = integer(1, 1, size_) - 1;
      if (symmetry_ == Symmetry::symmetric && column > row)
        lines_.refuse("the entry stands above the diagonal of a symmetric matrix", "the lower triangle alone",
                      1);
      if (symmetry_ == Symmetry::skew && column >= row)
        lines_.refuse("the entry does not stand below the diagonal of a skew-symmetric matrix",
                      "the strictly lower triangle alone", 1);
      if (seen[static_cast<std::size_t>(row * size_ + column)])
        lines_.refuse(fmt::format("row {}, column {} is given twice", row + 1, column + 1),
                      "each entry once");
      seen[static_cast<std::size_t>(row * size_ + column)] = true;
      put(row, column, number(2));
    }
    refuse_rest(fmt::format("{} entries", entries_));
  }

  void read_columns() {
    for (long column = 0; column < size_; ++column) {
      for (long row = first_row(symmetry_, column); row < size_; ++row) put(row, column, next_number());
    }
    if (word_ < words_of_line_)
      lines_.refuse("the matrix goes on", fmt::format("the numbers of {} columns", size_), word_);
    refuse_rest(fmt::format("the numbers of {} columns", size_));
  }

  /// The format requires one number a line in array files, but many programs write more.
  double next_number() {
    if (word_ == words_of_line_) {
      if (!lines_.next())
        lines_.refuse("the matrix ends too soon", fmt::format("the numbers of {} columns", size_));
      word_ = 0;
      words_of_line_ = lines_.words().size();
    }
    return number(word_++);
  }

  void refuse_rest(const std::string& allowed) {
    if (lines_.next()) lines_.refuse("the matrix goes on", allowed);
  }

  Lines lines_;
  Layout layout_ = Layout::coordinate;
  Symmetry symmetry_ = Symmetry::general;
  long size_ = 0, entries_ = 0;
  std::size_t word_ = 0, words_of_line_ = 0;
  Eigen::MatrixXd matrix_;
};

Symmetry symmetry_of(const Eigen::MatrixXd& matrix) {
  if (matrix == matrix.transpose()) return Symmetry::symmetric;
  return matrix == -matrix.transpose() ? Symmetry::skew : Symmetry::general;
}

using matlab::Variable;

constexpr std::string_view allowed_matrix = "a square matrix of real numbers, full or sparse";

std::nullopt_t refuse_missing(const std::vector<Variable>& variables, const std::string& variable,
                              const yaml::Value& value) {
  std::vector<std::string_view> known;
  for (const Variable& one : variables) known.push_back(one.name);
  const auto meant = yaml::nearest(variable, known);
  std::string list;
  for (const std::string_view name : known)
    list += fmt::format("{}{}", list.empty() ? "" : ", ", yaml::shown(name));
  return refuse(value,
                fmt::format("the file holds no '{}'{}", yaml::shown(variable),
                            meant ? fmt::format(" (did you mean '{}'?)", yaml::shown(*meant)) : ""),
                list.empty() ? "a file that holds one" : "variable: with one of " + yaml::shown(list, 200));
}

}  // namespace

std::optional<Eigen::MatrixXd> read_matrix_market(const yaml::Value& value) {
  if (value.node.kind != yaml::Node::Kind::scalar)
    return refuse(value, yaml::describe(value.node), "a map with file, or the text of a Matrix Market file");
  try {
    return MatrixReader(value.node.text).read();
  } catch (const Problem& problem) {
    if (value.node.quoted) {
      refuse(value, fmt::format("line {}: {}", problem.line, problem.wrong), problem.allowed);
    } else {
      value.diagnostics.add({-1, problem.line, problem.column, value.node.place.file}, value.path,
                            problem.wrong, problem.allowed);
    }
  }
  return std::nullopt;
}

std::string matrix_market(const Eigen::MatrixXd& matrix) {
  const Symmetry symmetry = symmetry_of(matrix);
  const Eigen::Index n = matrix.rows();
  std::string entries, columns;
  Eigen::Index count = 0;
  for (Eigen::Index column = 0; column < n; ++column) {
    for (Eigen::Index row = first_row(symmetry, column); row < n; ++row) {
      const double value = matrix(row, column) + 0.0;  // no -0
      columns += fmt::format("{}\n", value);
      if (value == 0) continue;
      entries += fmt::format("{} {} {}\n", row + 1, column + 1, value);
      ++count;
    }
  }
  const bool sparse = entries.size() <= columns.size();
  return fmt::format("%%MatrixMarket matrix {} real {}\n", layouts[sparse ? 0 : 1],
                     symmetries[static_cast<std::size_t>(symmetry)]) +
         (sparse ? fmt::format("{0} {0} {1}\n", n, count) + entries : fmt::format("{0} {0}\n", n) + columns);
}

std::optional<Eigen::MatrixXd> read_matlab_matrix(std::string_view bytes, const std::string& variable,
                                                  const yaml::Value& value) {
  constexpr std::size_t most = model::ShaftMatrices::most_degrees_of_freedom;
  std::vector<Variable> variables;
  try {
    variables = matlab::read_variables(bytes, [&](const Variable& one) {
      return one.name == variable && one.is_real_matrix() && one.dims[0] == one.dims[1] &&
             one.dims[0] <= most;
    });
  } catch (const matlab::FileError& error) {
    return refuse(value, "the file " + error.wrong, error.allowed);
  }
  const auto found = std::ranges::find(variables, variable, &Variable::name);
  if (found == variables.end()) return refuse_missing(variables, variable, value);
  const auto refuse_it = [&](const std::string& why) {
    return refuse(value, fmt::format("'{}' {}", yaml::shown(variable), why), allowed_matrix);
  };
  if (found->dims.size() != 2) return refuse_it("is no matrix");
  if (found->complex) return refuse_it("is complex");
  const std::size_t n = found->dims[0];
  if (n == 0 || n != found->dims[1]) return refuse_it(fmt::format("is {} x {}", n, found->dims[1]));
  if (n > most) return refuse_it(fmt::format("has more than {} rows", most));
  if (found->values.size() != n * n) return refuse_it("holds no real numbers");
  const auto rows = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd matrix = Eigen::Map<const Eigen::MatrixXd>(found->values.data(), rows, rows);
  if (!matrix.allFinite()) return refuse_it("holds a number that is not finite");
  return matrix;
}

}  // namespace rubsweep::config::machine
