#include "rubsweep/measurement/fit/machine_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/fit/first_values.hpp"

namespace rubsweep::fit {
namespace {

/// Residuals of all files, each divided by the noise of its file.
Eigen::VectorXd residuals_of(const MachineFit& problem, const std::vector<double>& noise_m,
                             const Eigen::VectorXd& values, LastRamps& ramps) {
  const scene::PreparedMachine machine = problem.machine(values);
  std::vector<Eigen::VectorXd> parts;
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < problem.data.size(); ++i) {
    const MeasuredData& data = problem.data[i];
    parts.emplace_back((measured_of(data) - modelled_of(problem, data, machine, values, ramps)) / noise_m[i]);
    count += parts.back().size();
  }
  Eigen::VectorXd all(count);
  Eigen::Index begin = 0;
  for (const Eigen::VectorXd& part : parts) {
    all.segment(begin, part.size()) = part;
    begin += part.size();
  }
  return all;
}

/// First guess of a file's noise: a hundredth of the size of its data. It weights them in the first fit.
double rough_noise_m(const MeasuredData& data) {
  const Eigen::VectorXd measured = measured_of(data);
  const double mean = measured.mean();
  return std::max(0.01 * std::sqrt((measured.array() - mean).square().mean() + mean * mean * 1e-6), 1e-300);
}

/// Refuses a rate as a parameter for ramps with knots: their speed does not change at one single rate.
void refuse_rate_of_uneven_ramps(const MachineFit& problem) {
  if (std::ranges::find(problem.parameters, rate_name, &Parameter::name) == problem.parameters.end()) return;
  for (const MeasuredData& data : problem.data) {
    const auto* run = std::get_if<RunUp>(&data.data);
    if (run != nullptr && !run->ramp.even())
      throw ConfigError(data.name + ": has a speed that changes unevenly, allowed with " + rate_name +
                        ": one that changes evenly");
  }
}

/// Makes the rubs at these parameter values the starting points for the rubs at later values.
void follow_rubs(const MachineFit& problem, const Eigen::VectorXd& values) {
  if (!problem.follow_rub) return;
  for (const MeasuredData& data : problem.data)
    if (const auto* rub = std::get_if<RubLines>(&data.data))
      problem.follow_rub(problem.machine(values), *rub,
                         value_named(problem, values, eccentricity_name, problem.eccentricity_m));
}

Eigen::VectorXd start_of(const MachineFit& problem) {
  Eigen::VectorXd start(static_cast<Eigen::Index>(problem.parameters.size()));
  for (Eigen::Index i = 0; i < start.size(); ++i)
    start(i) = problem.parameters[static_cast<std::size_t>(i)].start;
  return start;
}

/// Removes the bounds of angles that may have any value of a turn. Otherwise a descent might end at a bound
/// although the solution lies beyond this bound.
void open_whole_turns(LeastSquares& squares) {
  constexpr double turn_deg = 360;
  for (Parameter& angle : squares.parameters) {
    if (!angle.name.ends_with("_deg") || angle.high - angle.low < turn_deg) continue;
    angle.low -= turn_deg / 2;
    angle.high += turn_deg / 2;
  }
}

/// Brings the angles of open_whole_turns back between their bounds.
void close_whole_turns(const MachineFit& problem, LeastSquaresFit& fit) {
  constexpr double turn_deg = 360;
  for (Eigen::Index i = 0; i < fit.value.size(); ++i) {
    const Parameter& angle = problem.parameters[static_cast<std::size_t>(i)];
    if (!angle.name.ends_with("_deg") || angle.high - angle.low < turn_deg) continue;
    while (fit.value(i) < angle.low) fit.value(i) += turn_deg;
    while (fit.value(i) > angle.high) fit.value(i) -= turn_deg;
  }
}

/// Range of each file's residuals among all residuals.
std::vector<DataResidual> parts_of(const MachineFit& problem, const std::vector<double>& noise_m) {
  std::vector<DataResidual> parts;
  int begin = 0;
  for (std::size_t i = 0; i < problem.data.size(); ++i) {
    const MeasuredData& data = problem.data[i];
    const auto count = static_cast<int>(measured_of(data).size());
    parts.push_back({data.name, begin, count, eliminated_of(data), noise_m[i]});
    begin += count;
  }
  return parts;
}

/// Rows of the run-ups' residuals by instant. Rows are correlated: an error of a mark rotates all 1X values
/// of an instant and, through smoothing, those of neighbouring instants.
std::vector<RowsInTime> rows_in_time(const MachineFit& problem, const MachineFitResult& result) {
  std::vector<RowsInTime> found;
  for (std::size_t i = 0; i < problem.data.size(); ++i)
    if (const auto* run = std::get_if<RunUp>(&problem.data[i].data))
      found.push_back({result.data[i].begin, run->phasor_m.rows(), 2 * run->phasor_m.cols()});
  return found;
}

/// Sets the noise of each file from its residuals; returns the largest change of its logarithm.
double weigh_anew(const MachineFitResult& result, std::vector<double>& noise_m) {
  double change = 0;
  for (std::size_t i = 0; i < noise_m.size(); ++i) {
    const DataResidual& data = result.data[i];
    const auto part = result.fit.residuals.segment(data.begin, data.count);
    const double factor =
        std::max(std::sqrt(part.squaredNorm() / std::max(data.count - data.eliminated, 1)), 1e-9);
    noise_m[i] *= factor;
    change = std::max(change, std::abs(std::log(factor)));
  }
  return change;
}

/// Schwarz' criterion of a fit with this number of parameters.
double bic_of(const MachineFitResult& result, std::size_t parameters) {
  double bic = static_cast<double>(parameters) * std::log(static_cast<double>(result.fit.residuals.size()));
  for (const DataResidual& data : result.data) {
    const double square = result.fit.residuals.segment(data.begin, data.count).squaredNorm() / data.count;
    bic += data.count * std::log(square * data.noise_m * data.noise_m);
  }
  return bic;
}

}  // namespace

MachineFitResult fit_machine(const MachineFit& problem, const LeastSquaresOptions& options) {
  refuse_rate_of_uneven_ramps(problem);
  std::vector<double> noise_m;
  for (const MeasuredData& data : problem.data) noise_m.push_back(rough_noise_m(data));
  LastRamps ramps(problem);
  Eigen::VectorXd start = start_of(problem);
  // Errors at the first values are thrown here, because a descent would only take these values as impossible.
  follow_rubs(problem, start);
  residuals_of(problem, noise_m, start, ramps);
  LeastSquares squares{
      .parameters = problem.parameters,
      .residuals = [&](const Eigen::VectorXd& at) { return residuals_of(problem, noise_m, at, ramps); },
      .accepted = [&](const Eigen::VectorXd& values) { follow_rubs(problem, values); }};
  open_whole_turns(squares);
  find_first_values(problem, squares, options, start);
  begin_at(start, squares);
  MachineFitResult result;
  result.fit = least_squares(squares, options);
  if (result.fit.value.size() == 0) return result;
  result.data = parts_of(problem, noise_m);
  LeastSquaresOptions again = options;
  again.starts = 1;
  // The first fit may overweight noisy data, so that a few rounds estimate the noise of each file again.
  constexpr int most_rounds = 4;
  constexpr double settled = 0.05;
  double change = problem.data.size() > 1 ? INFINITY : 0;
  for (int round = 0; round < most_rounds && change > settled && !result.fit.stopped; ++round) {
    change = weigh_anew(result, noise_m);
    begin_at(result.fit.value, squares);
    const int starts = result.fit.starts, agreeing = result.fit.agreeing;
    LeastSquaresFit next = least_squares(squares, again);
    if (next.value.size() == 0) {
      result.fit.stopped = true;
      break;
    }
    result.fit = std::move(next);
    result.fit.starts = starts;
    result.fit.agreeing = agreeing;
    result.data = parts_of(problem, noise_m);
  }
  close_whole_turns(problem, result.fit);
  int eliminated = 0;
  for (const DataResidual& data : result.data) eliminated += data.eliminated;
  result.uncertainty = uncertainty_of(result.fit, eliminated);
  allow_for_correlation(result.fit, rows_in_time(problem, result), result.uncertainty);
  result.bic = bic_of(result, problem.parameters.size());
  return result;
}

}  // namespace rubsweep::fit
