#include "rubsweep/measurement/fit/measured_table.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <exception>
#include <numbers>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/straight_line.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/table/rows.hpp"

namespace rubsweep::fit {
namespace {

/// Number of turns from the first row to each row, where rows are whole turns apart; else empty.
std::vector<double> whole_turns(const std::vector<double>& t_s, const std::vector<double>& speed_hz) {
  constexpr double whole_to = 0.1;
  std::vector<double> turns{0};
  for (std::size_t k = 1; k < t_s.size(); ++k) {
    const double passed = (speed_hz[k - 1] + speed_hz[k]) / 2 * (t_s[k] - t_s[k - 1]);
    if (passed < 1 - whole_to || std::abs(passed - std::round(passed)) > whole_to) return {};
    turns.push_back(turns.back() + std::round(passed));
  }
  return turns;
}

/// Chebyshev polynomials and their time derivatives, one column per degree.
struct Chebyshev {
  Eigen::MatrixXd value, rate;
};

Chebyshev chebyshev(const std::vector<double>& t_s, Eigen::Index degree) {
  const auto count = static_cast<Eigen::Index>(t_s.size());
  const double half_s = (t_s.back() - t_s.front()) / 2;
  const Eigen::ArrayXd x =
      (Eigen::Map<const Eigen::ArrayXd>(t_s.data(), count) - (t_s.front() + half_s)) / half_s;
  Chebyshev basis{Eigen::MatrixXd::Ones(count, degree + 1), Eigen::MatrixXd::Zero(count, degree + 1)};
  basis.value.col(1) = x;
  basis.rate.col(1).setConstant(1 / half_s);
  for (Eigen::Index n = 2; n <= degree; ++n) {
    basis.value.col(n) = 2 * x * basis.value.col(n - 1).array() - basis.value.col(n - 2).array();
    basis.rate.col(n) = 2 * basis.value.col(n - 1).array() / half_s + 2 * x * basis.rate.col(n - 1).array() -
                        basis.rate.col(n - 2).array();
  }
  return basis;
}

/// Speeds from two polynomials fitted to the measured values: one of the `least` degree, and one of the
/// degree with the best Schwarz criterion. The penalty of this criterion is tripled, because errors of
/// smoothed marks are correlated.
struct Polynomials {
  Eigen::ArrayXd least_hz, best_hz;
};

Polynomials polynomials(const std::vector<double>& t_s, const std::vector<double>& measured,
                        Eigen::Index least, bool of_turns) {
  const auto count = static_cast<Eigen::Index>(t_s.size());
  const auto n = static_cast<double>(count);
  constexpr double penalty = 3, most_degree = 24;
  const auto most =
      std::max(least, static_cast<Eigen::Index>(std::min({most_degree, 1.5 * std::sqrt(n), n / 4 - 1})));
  const Chebyshev basis = chebyshev(t_s, most);
  const Eigen::Map<const Eigen::VectorXd> all(measured.data(), count);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(basis.value);
  const Eigen::VectorXd rotated = qr.householderQ().transpose() * all;
  const auto speeds_of = [&](Eigen::Index degree) -> Eigen::ArrayXd {
    const Eigen::VectorXd found = qr.matrixQR()
                                      .topLeftCorner(degree + 1, degree + 1)
                                      .triangularView<Eigen::Upper>()
                                      .solve(rotated.head(degree + 1));
    return ((of_turns ? basis.rate : basis.value).leftCols(degree + 1) * found).array();
  };
  // Residuals below rounding must not decide the degree.
  const double rounding = n * std::pow(1e-13 * (1 + all.cwiseAbs().maxCoeff()), 2);
  Eigen::Index best = least;
  double least_criterion = INFINITY;
  for (Eigen::Index degree = least; degree <= most; ++degree) {
    const double left = rotated.tail(count - degree - 1).squaredNorm() + rounding;
    const double criterion = n * std::log(left) + penalty * static_cast<double>(degree) * std::log(n);
    if (!(criterion < least_criterion)) continue;
    least_criterion = criterion;
    best = degree;
  }
  return {speeds_of(least), speeds_of(best)};
}

struct Unit {
  std::string_view written, ending;
  double size;
};

constexpr std::array<Unit, 15> units{{{"s", "_s", 1},
                                      {"ms", "_s", 1e-3},
                                      {"us", "_s", 1e-6},
                                      {"m", "_m", 1},
                                      {"mm", "_m", 1e-3},
                                      {"um", "_m", 1e-6},
                                      {"mil", "_m", 25.4e-6},
                                      {"Hz", "_hz", 1},
                                      {"rpm", "_hz", 1.0 / 60},
                                      {"1/min", "_hz", 1.0 / 60},
                                      {"rev/min", "_hz", 1.0 / 60},
                                      {"rad/s", "_hz", 0.5 / std::numbers::pi},
                                      {"deg", "_deg", 1},
                                      {"\u00b0", "_deg", 1},
                                      {"rad", "_deg", 180 / std::numbers::pi}}};

/// Name of a column in the programs' own form, and the factor that converts its unit. A name with an unknown
/// unit stays without a unit, so it is not found.
std::pair<std::string, double> own_name(const table::Heading& heading) {
  std::string name;
  for (const char c : heading.name)
    name += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (name == "time") name = "t";
  if (heading.unit.empty()) return {name, 1};
  const auto unit = std::ranges::find(units, table::plain_unit(heading.unit), &Unit::written);
  if (unit == units.end()) return {name + " [" + heading.unit + ']', 1};
  if (!name.ends_with(unit->ending)) name += unit->ending;
  return {name, unit->size};
}

}  // namespace

MeasuredTable::MeasuredTable(const std::filesystem::path& file, std::string_view needed) : path_(file) {
  std::exception_ptr fault;
  try {
    own_.emplace(file);
    own_->column(needed);
    return;
  } catch (const IoError&) {
    fault = std::current_exception();
  }
  own_.reset();
  if (!read_of_somebody(needed)) std::rethrow_exception(fault);
}

bool MeasuredTable::read_of_somebody(std::string_view needed) {
  std::string text;
  table::Layout layout;
  std::vector<double> sizes;
  std::vector<std::size_t> places;
  try {
    const std::string bytes = batch::read_input(path_);
    // a damaged table of the programs' own form must not be read as a foreign table
    batch::check_table_text(bytes, path_);
    text = table::utf8_of(bytes);
    layout = table::layout_of(text);
  } catch (const table::Fault&) {
    return false;  // the reader of the programs' own form gives the message instead
  }
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    if (layout.columns[i].is_text) continue;
    auto [name, size] = own_name(layout.columns[i].heading);
    header_.push_back(std::move(name));
    sizes.push_back(size);
    places.push_back(i);
  }
  if (std::ranges::count(header_, needed) != 1) return false;
  try {
    table::Rows rows(text, layout);
    while (rows.next()) {
      if (rows.is_empty()) continue;
      lines_.push_back(rows.line());
      rows_.emplace_back();
      for (std::size_t k = 0; k < places.size(); ++k)
        rows_.back().push_back(places[k] < rows.cells().size() ? sizes[k] * rows.number(places[k]) : NAN);
    }
  } catch (const table::Fault& fault) {
    throw ConfigError(fmt::format("{}:{}:{}: {}, allowed: {}", path_.string(), fault.line, fault.column,
                                  fault.wrong, fault.allowed));
  }
  return true;
}

std::size_t MeasuredTable::column(std::string_view name) const {
  if (own_) return own_->column(name);
  const auto found = std::ranges::find(header_, name);
  if (found != header_.end() && std::ranges::count(header_, name) == 1)
    return static_cast<std::size_t>(found - header_.begin());
  throw IoError(fmt::format("{}: has no column '{}', or two of them, only: {}", path_.string(), name,
                            fmt::join(header_, ", ")));
}

bool MeasuredTable::next() {
  if (own_) return own_->next();
  if (row_ == rows_.size()) return false;
  ++row_;
  return true;
}

double MeasuredTable::number(std::size_t column) const {
  return own_ ? own_->number(column) : rows_[row_ - 1][column];
}

batch::CsvReader::RowPosition MeasuredTable::place() const {
  return own_ ? own_->place() : batch::CsvReader::RowPosition{0, lines_[row_ - 1]};
}

Ramp measured_ramp(const std::vector<double>& t_s, const std::vector<double>& speed_hz) {
  constexpr double followed = 0.02, even = 2e-4;
  const auto count = static_cast<Eigen::Index>(t_s.size());
  const Eigen::Map<const Eigen::ArrayXd> speeds(speed_hz.data(), count);
  const std::vector<double> turns = whole_turns(t_s, speed_hz);
  const Polynomials through =
      turns.empty() ? polynomials(t_s, speed_hz, 1, false) : polynomials(t_s, turns, 2, true);
  const numerics::StraightLine line = numerics::line_through(t_s, speed_hz);
  const double change = std::abs(line.slope * (t_s.back() - t_s.front()));
  if ((through.best_hz - speeds).abs().maxCoeff() > followed * change)
    return {speed_hz.front(), 0, t_s, speed_hz};
  const double off = std::sqrt((through.best_hz - through.least_hz).square().mean());
  if (off > even * speeds.mean())
    return {through.best_hz(0), 0, t_s, {through.best_hz.data(), through.best_hz.data() + count}};
  const double rate = (through.least_hz(count - 1) - through.least_hz(0)) / (t_s.back() - t_s.front());
  return {through.least_hz(0) - rate * t_s.front(), rate};
}

}  // namespace rubsweep::fit
