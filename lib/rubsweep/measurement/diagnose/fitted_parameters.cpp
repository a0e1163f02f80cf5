#include "rubsweep/measurement/diagnose/fitted_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"

namespace rubsweep::diagnose {
namespace {

namespace fs = std::filesystem;

/// Half width of the central 95 % interval of a normal distribution, in standard deviations.
constexpr double deviations_of_95 = 1.959963984540054;

[[noreturn]] void fail(const batch::CsvReader& rows, const std::string& what) {
  throw IoError(fmt::format("{}:{}: {}", rows.path().string(), rows.place().line, what));
}

/// Refuses numbers that cannot come from a fit: an interval has two finite ends or two infinite ends.
void require_interval(const batch::CsvReader& rows, const std::string& name, double value, double low,
                      double high) {
  if (!std::isfinite(value)) fail(rows, fmt::format("{}: value: is no number, allowed: a finite one", name));
  const bool none = std::isnan(low) && std::isnan(high);
  if (!none && !(low <= value && value <= high)) {
    fail(rows,
         fmt::format("{}: value: is {}, allowed: from low_95 {} to high_95 {}", name, value, low, high));
  }
}

/// Whether a matrix can be a correlation matrix, apart from rounding in the file.
bool are_correlations(const Eigen::MatrixXd& correlation) {
  constexpr double rounding = 1e-6;
  return (correlation - correlation.transpose()).cwiseAbs().maxCoeff() <= rounding &&
         (correlation.diagonal().array() - 1).abs().maxCoeff() <= rounding &&
         correlation.cwiseAbs().maxCoeff() <= 1 + rounding &&
         numerics::dense::self_adjoint_modes(correlation).values.minCoeff() >= -rounding;
}

Eigen::MatrixXd read_correlation(const fs::path& file, const std::vector<std::string>& names) {
  const auto count = static_cast<Eigen::Index>(names.size());
  if (!fs::exists(file)) return Eigen::MatrixXd::Identity(count, count);
  Eigen::MatrixXd correlation(count, count);
  batch::CsvReader rows(file);
  const std::size_t parameter = rows.column("parameter");
  for (Eigen::Index i = 0; i < count; ++i) {
    if (!rows.next()) throw IoError(file.string() + ": ends before the last of the parameters");
    if (rows.cells()[parameter] != names[static_cast<std::size_t>(i)])
      fail(rows, fmt::format("is the row of '{}', allowed: that of '{}'", rows.cells()[parameter],
                             names[static_cast<std::size_t>(i)]));
    for (Eigen::Index j = 0; j < count; ++j)
      correlation(i, j) = rows.number(rows.column(names[static_cast<std::size_t>(j)]));
  }
  if (!correlation.allFinite()) throw IoError(file.string() + ": has a cell without a number");
  if (count > 0 && !are_correlations(correlation)) {
    throw IoError(file.string() +
                  ": holds no correlations, allowed: numbers from -1 to 1, 1 of a parameter with "
                  "itself, the same for both orders of two");
  }
  return correlation;
}

}  // namespace

std::optional<FittedParameters> read_fitted_parameters(const fs::path& directory) {
  const fs::path table = directory / "parameters.csv", correlation = directory / "correlation.csv";
  if (!fs::exists(table)) return std::nullopt;
  FittedParameters fitted;
  batch::CsvReader rows(table);
  const std::size_t name = rows.column("parameter"), value = rows.column("value"),
                    low = rows.column("low_95"), high = rows.column("high_95");
  std::vector<std::array<double, 3>> numbers;
  while (rows.next()) {
    if (std::ranges::find(fitted.name, rows.cells()[name]) != fitted.name.end())
      fail(rows, fmt::format("{}: is there twice, allowed: one row of each parameter", rows.cells()[name]));
    fitted.name.push_back(rows.cells()[name]);
    const auto& [found, from, to] =
        numbers.emplace_back(std::array{rows.number(value), rows.number(low), rows.number(high)});
    require_interval(rows, fitted.name.back(), found, from, to);
  }
  const auto count = static_cast<Eigen::Index>(numbers.size());
  for (Eigen::VectorXd* column : {&fitted.value, &fitted.low_95, &fitted.high_95}) column->resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& row = numbers[static_cast<std::size_t>(i)];
    fitted.value(i) = row[0];
    fitted.low_95(i) = row[1];
    fitted.high_95(i) = row[2];
  }
  const auto modes = numerics::dense::self_adjoint_modes(read_correlation(correlation, fitted.name));
  // Rounding in the file may leave eigenvalues a little below 0.
  fitted.error_root = modes.vectors * modes.values.cwiseMax(0).cwiseSqrt().asDiagonal();
  fitted.text = batch::read_input(table);
  if (fs::exists(correlation)) fitted.text += batch::read_input(correlation);
  return fitted;
}

std::optional<Spread> interval_of(const FittedParameters& fitted, std::string_view name) {
  const auto found = std::ranges::find(fitted.name, name);
  if (found == fitted.name.end()) return std::nullopt;
  const Eigen::Index i = found - fitted.name.begin();
  return Spread{fitted.low_95(i), fitted.high_95(i), false};
}

Eigen::VectorXd draw_parameters(const FittedParameters& fitted, RandomStream& random) {
  Eigen::VectorXd normal(fitted.value.size());
  for (double& x : normal) x = random.normal();
  const Eigen::ArrayXd width = (fitted.high_95 - fitted.low_95).array();
  const Eigen::ArrayXd deviation = width.isFinite().select(width, 0) / (2 * deviations_of_95);
  return fitted.value + (deviation * (fitted.error_root * normal).array()).matrix();
}

}  // namespace rubsweep::diagnose
