#include "rubfit/fit_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/measurement/fit/modelled_data.hpp"
#include "rubsweep/measurement/fit/uncertainty.hpp"

namespace rubsweep::apps {

using namespace fit;

namespace {

using batch::csv_number;

/// One series of numbers in a file: a sensor's signal, or the real or imaginary parts of its 1X.
struct Series {
  std::string kind, part;
  Eigen::Index sensor = 0, begin = 0;
  std::vector<double> at;
};

std::vector<Series> phasor_series(const std::string& kind, const std::vector<double>& at,
                                  Eigen::Index sensors) {
  std::vector<Series> series;
  const auto count = static_cast<Eigen::Index>(at.size());
  for (const char* part : {"real", "imaginary"})
    for (Eigen::Index i = 0; i < sensors; ++i)
      series.push_back({kind, part, i, static_cast<Eigen::Index>(series.size()) * count, at});
  return series;
}

std::vector<Series> series_of(const MeasuredData& data) {
  return std::visit(
      overloaded{[](const RingDown& ring) {
                   std::vector<Series> series;
                   for (Eigen::Index i = 0; i < ring.signal_m.cols(); ++i)
                     series.push_back({"ring_down", "signal", i, i * ring.signal_m.rows(), ring.t_s});
                   return series;
                 },
                 [](const RunUp& run) {
                   std::vector<double> speeds;
                   for (const double t : run.t_s) speeds.push_back(speed_hz(run.ramp, t));
                   return phasor_series("run_up", speeds, run.phasor_m.cols());
                 },
                 [](const Steady& steady) {
                   return phasor_series("steady", steady.speed_hz, steady.phasor_m.cols());
                 },
                 [](const RubLines& rub) { return phasor_series("rub", rub.order, 1); }},
      data.data);
}

/// Sentence about the residuals of one of `of_series` series; empty where they are noise. In a run-up
/// neighbouring residuals are always correlated, since its readings are interpolated and its marks smoothed.
/// For a run-up, a correlation is therefore reported only if the correlated part exceeds the share of_run_ups
/// of 1X.
std::string doubt_of(const Series& series, std::span<const double> residuals, double size_m,
                     std::size_t of_series) {
  constexpr double level = 1e-3, of_run_ups = 0.03;
  // Neighbouring lines of a spectrum are not neighbours in time.
  if (series.kind == "rub") return {};
  const ResidualTest test = test_residuals(residuals, level / static_cast<double>(of_series));
  if (test.white) return {};
  double square = 0;
  for (const double value : residuals) square += value * value / static_cast<double>(residuals.size());
  if (series.kind == "run_up" &&
      std::sqrt(std::max(0.0, test.first_correlation) * square) < of_run_ups * size_m)
    return {};
  if (test.line_stands_out && series.kind == "ring_down") {
    const double step_s = (series.at.back() - series.at.front()) / static_cast<double>(series.at.size() - 1);
    return fmt::format("a vibration of {:.4g} Hz remains, {:.2g} % of what is left", test.line / step_s,
                       100 * test.line_share);
  }
  return fmt::format("neighbours hang together, correlation {:.2f}", test.first_correlation);
}

/// Smallest number of rows of a series for which noise can be distinguished from a misfit.
constexpr std::size_t fewest_to_test = 24;

/// Line about a file whose residuals exceed a tenth of its size and are not noise. `doubted`: whether its
/// residuals are not white.
std::string too_much_left(const MeasuredData& data, const WhatIsLeft& left, bool doubted) {
  constexpr double too_much = 0.1;
  if (!(left.share() > too_much) || !doubted) return {};
  return fmt::format("warning   {:.0f} % of {} are left over: not the right minimum (--starts), bounds{}\n",
                     100 * left.share(), data.name,
                     has_phases_of_a_table(data) ? ", phases (--phase) or machine" : " or machine");
}

std::string parameters_csv(const MachineFit& problem, const MachineFitResult& result) {
  std::string text = "parameter,value,standard_error,low_95,high_95,start,at_bound\n";
  for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double value = result.fit.value(k), half = result.uncertainty.half_width(k);
    text += fmt::format("{},{},{},{},{},{},{}\n", problem.parameters[i].name, csv_number(value),
                        csv_number(result.uncertainty.standard_error(k)), csv_number(value - half),
                        csv_number(value + half), csv_number(problem.parameters[i].start),
                        result.fit.at_bound[i] ? 1 : 0);
  }
  return text;
}

std::string correlation_csv(const MachineFit& problem, const MachineFitResult& result) {
  std::string text = "parameter";
  for (const Parameter& parameter : problem.parameters) text += ',' + parameter.name;
  text += '\n';
  for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
    text += problem.parameters[i].name;
    for (std::size_t j = 0; j < problem.parameters.size(); ++j)
      text += ',' + csv_number(result.uncertainty.correlation(static_cast<Eigen::Index>(i),
                                                              static_cast<Eigen::Index>(j)));
    text += '\n';
  }
  return text;
}

/// Lines about a fit, its parameters and what its data do not tell apart.
std::string parameters_text(const MachineFit& problem, const MachineFitResult& result) {
  const LeastSquaresFit& fit = result.fit;
  std::string text = fmt::format(
      "fit       {} numbers of data, {} parameters; {} after {} steps; {} of {} starts lead there\n",
      fit.residuals.size(), problem.parameters.size(),
      fit.stopped     ? "stopped"
      : fit.converged ? "settled"
                      : "not settled",
      fit.iterations, fit.agreeing, fit.starts);
  for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    text += fmt::format("          {} = {:.6g} +- {:.2g} (95 %: {:.6g} to {:.6g}){}\n",
                        problem.parameters[i].name, fit.value(k), result.uncertainty.standard_error(k),
                        fit.value(k) - result.uncertainty.half_width(k),
                        fit.value(k) + result.uncertainty.half_width(k),
                        fit.at_bound[i] ? ", AT ITS BOUND: the interval does not hold" : "");
  }
  for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double correlation =
          result.uncertainty.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      if (std::abs(correlation) > 0.95)
        text += fmt::format("          {} and {} go together, correlation {:.3f}\n",
                            problem.parameters[j].name, problem.parameters[i].name, correlation);
    }
  }
  for (const std::string& sentence : untold_combinations(result.uncertainty, problem.parameters))
    text += fmt::format("warning   {}\n", sentence);
  return text;
}

/// Adds the residuals of file `d` to the tables, and to the summary what is left and what may be missing.
void add_residuals(const MachineFit& problem, std::size_t d, const Eigen::VectorXd& value,
                   const model::Machine& machine, FitTables& tables) {
  const ModelledData both = modelled(problem, d, value);
  const WhatIsLeft left = what_is_left(problem, d, value);
  tables.summary += fmt::format(
      "left      {:.3g} um of {:.3g} um in {}\n", 1e6 * left.left_m,
      1e6 * std::sqrt(both.measured_m.squaredNorm() / static_cast<double>(both.measured_m.size())),
      problem.data[d].name);
  std::string doubts;
  bool doubted = false;
  const std::vector<Series> all_series = series_of(problem.data[d]);
  for (const Series& series : all_series) {
    std::vector<double> residuals;
    for (std::size_t k = 0; k < series.at.size(); ++k) {
      const Eigen::Index row = series.begin + static_cast<Eigen::Index>(k);
      residuals.push_back(both.measured_m(row) - both.modelled_m(row));
      tables.residuals_csv += fmt::format("{},{},{},{},{},{},{}\n", d, series.kind, series.sensor,
                                          series.part, csv_number(series.at[k]),
                                          csv_number(both.measured_m(row)), csv_number(both.modelled_m(row)));
    }
    const std::string doubt = doubt_of(series, residuals, left.size_m, all_series.size());
    doubted = doubted || !doubt.empty() || series.kind == "rub" || residuals.size() < fewest_to_test;
    if (!doubt.empty())
      doubts += fmt::format(
          "warning   something is missing in the {} of sensor {}{}: {}\n", series.part, series.sensor,
          model::in_brackets(model::sensor_name(machine, static_cast<std::size_t>(series.sensor))), doubt);
  }
  tables.summary += too_much_left(problem.data[d], left, doubted) + doubts;
}

}  // namespace

FitTables tables_of(const MachineFit& problem, const MachineFitResult& result,
                    const model::Machine& machine) {
  FitTables tables{parameters_csv(problem, result), correlation_csv(problem, result),
                   "data,kind,sensor,part,at,measured_m,modelled_m\n", parameters_text(problem, result)};
  for (std::size_t d = 0; d < problem.data.size(); ++d)
    add_residuals(problem, d, result.fit.value, machine, tables);
  return tables;
}

std::string comparison_text(const MachineFitResult& with, const MachineFitResult& less,
                            const std::string& without) {
  // The levels 2, 6 and 10 of the difference are from Kass and Raftery, J. Am. Stat. Assoc. 90 (1995).
  const double difference = less.bic - with.bic;
  const char* words = difference > 10   ? "the data need it"
                      : difference > 6  ? "the data speak strongly for it"
                      : difference > 2  ? "the data speak for it"
                      : difference > -2 ? "the data do not tell"
                                        : "the data speak against it";
  return fmt::format("compared  without {}: {} (Schwarz' criterion {:+.1f})\n", without, words, difference);
}

}  // namespace rubsweep::apps
