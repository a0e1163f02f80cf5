#include "rubsweep/measurement/fit/least_squares.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <random>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::fit {
namespace {

constexpr double relative_step = 1e-5;

bool is_stopped(const LeastSquaresOptions& options) {
  return options.stop != nullptr && options.stop->load();
}

/// Residuals and derivatives at one point, computed once for all residuals. After a stop nothing more is
/// evaluated: the solver gets zero derivatives, which end it normally.
class Evaluation : public ceres::EvaluationCallback {
 public:
  Evaluation(const LeastSquares& problem, const LeastSquaresOptions& options)
      : problem_(problem),
        options_(options),
        scaled_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.parameters.size()))) {}

  double* scaled() { return scaled_.data(); }

  Eigen::VectorXd values() const { return values_of(scaled_); }

  void PrepareForEvaluation(bool with_jacobian, bool new_point) override {
    if (is_stopped(options_) && residuals_.size() > 0) {
      leave_off();
      return;
    }
    if (new_point || residuals_.size() == 0) {
      possible_ = evaluate(scaled_, residuals_);
      jacobian_.resize(0, 0);
    }
    if (with_jacobian && possible_ && jacobian_.size() == 0) differentiate();
  }

  bool possible() const { return possible_; }
  /// Whether the derivatives were computed; false after a stop, when they are zero.
  bool whole() const { return whole_; }
  const Eigen::VectorXd& residuals() const { return residuals_; }
  /// Derivatives with respect to the parameters in units of their scales.
  const Eigen::MatrixXd& jacobian() const { return jacobian_; }

 private:
  Eigen::VectorXd values_of(const Eigen::VectorXd& scaled) const {
    Eigen::VectorXd values = scaled;
    for (Eigen::Index i = 0; i < values.size(); ++i)
      values(i) *= problem_.parameters[static_cast<std::size_t>(i)].scale;
    return values;
  }

  bool evaluate(const Eigen::VectorXd& scaled, Eigen::VectorXd& residuals) const {
    if (is_stopped(options_)) return false;
    try {
      residuals = problem_.residuals(values_of(scaled));
      return residuals.allFinite();
    } catch (const ConfigError&) {
      return false;
    } catch (const SolverError&) {
      return false;
    }
  }

  /// Computes one column by central differences. The difference is one-sided at a bound, or where the
  /// residuals exist on one side only.
  bool differentiate(Eigen::Index i) {
    const Parameter& parameter = problem_.parameters[static_cast<std::size_t>(i)];
    Eigen::VectorXd up = scaled_, down = scaled_, above, below;
    up(i) += relative_step;
    down(i) -= relative_step;
    const bool has_up = up(i) * parameter.scale <= parameter.high && evaluate(up, above);
    const bool has_down = down(i) * parameter.scale >= parameter.low && evaluate(down, below);
    if (!has_up && !has_down) return false;
    if (!has_up) above = residuals_;
    if (!has_down) below = residuals_;
    jacobian_.col(i) = (above - below) / (relative_step * (has_up && has_down ? 2 : 1));
    return true;
  }

  void differentiate() {
    jacobian_.resize(residuals_.size(), scaled_.size());
    const auto every_second = [this](Eigen::Index first) {
      bool all = true;
      for (Eigen::Index i = first; i < scaled_.size(); i += 2) all = differentiate(i) && all;
      return all;
    };
    auto other = std::async(std::launch::async, every_second, 1);
    const bool mine = every_second(0);
    possible_ = other.get() && mine;
    if (is_stopped(options_)) leave_off();
  }

  void leave_off() {
    whole_ = false;
    possible_ = true;
    jacobian_.setZero(residuals_.size(), scaled_.size());
  }

  const LeastSquares& problem_;
  const LeastSquaresOptions& options_;
  Eigen::VectorXd scaled_, residuals_;
  Eigen::MatrixXd jacobian_;
  bool possible_ = false, whole_ = true;
};

/// A single residual for Ceres, read from the shared evaluation.
class Residual : public ceres::CostFunction {
 public:
  Residual(const Evaluation& evaluation, Eigen::Index row, int parameters)
      : evaluation_(evaluation), row_(row) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(parameters);
  }

  bool Evaluate(const double* const*, double* residuals, double** jacobians) const override {
    if (!evaluation_.possible()) return false;
    residuals[0] = evaluation_.residuals()(row_);
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    if (evaluation_.jacobian().rows() == 0) return false;
    for (Eigen::Index i = 0; i < evaluation_.jacobian().cols(); ++i)
      jacobians[0][i] = evaluation_.jacobian()(row_, i);
    return true;
  }

 private:
  const Evaluation& evaluation_;
  Eigen::Index row_;
};

/// Best point of a descent so far; empty until its derivatives are computed.
struct Reached {
  Eigen::VectorXd value, residuals;
  Eigen::MatrixXd jacobian;
  double cost = INFINITY;
};

class Watch : public ceres::IterationCallback {
 public:
  Watch(const LeastSquares& problem, const Evaluation& evaluation, const LeastSquaresOptions& options,
        int start)
      : problem_(problem), evaluation_(evaluation), options_(options), start_(start) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (problem_.accepted && summary.step_is_successful) problem_.accepted(evaluation_.values());
    if (options_.on_iteration) options_.on_iteration(start_, summary.iteration, summary.cost);
    if ((summary.iteration == 0 || summary.step_is_successful) && evaluation_.whole())
      reached_ = {evaluation_.values(), evaluation_.residuals(), evaluation_.jacobian(), summary.cost};
    return is_stopped(options_) ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

  const Reached& reached() const { return reached_; }

 private:
  const LeastSquares& problem_;
  const Evaluation& evaluation_;
  const LeastSquaresOptions& options_;
  int start_;
  Reached reached_;
};

/// Descent from one start. The cost is infinite where the residuals do not exist at the start.
LeastSquaresFit descend(const LeastSquares& problem, const Eigen::VectorXd& from,
                        const LeastSquaresOptions& options, int start, double robust_size) {
  const auto count = static_cast<Eigen::Index>(problem.parameters.size());
  Evaluation evaluation(problem, options);
  for (Eigen::Index i = 0; i < count; ++i)
    evaluation.scaled()[i] = from(i) / problem.parameters[static_cast<std::size_t>(i)].scale;
  evaluation.PrepareForEvaluation(false, true);
  LeastSquaresFit fit;
  fit.cost = INFINITY;
  if (!evaluation.possible()) return fit;
  if (problem.accepted) problem.accepted(from);
  ceres::Problem::Options ownership;
  ownership.evaluation_callback = &evaluation;
  ceres::Problem descent(ownership);
  for (Eigen::Index row = 0; row < evaluation.residuals().size(); ++row) {
    descent.AddResidualBlock(new Residual(evaluation, row, static_cast<int>(count)),
                             robust_size > 0 ? new ceres::HuberLoss(robust_size) : nullptr,
                             evaluation.scaled());
  }
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const Parameter& parameter = problem.parameters[static_cast<std::size_t>(i)];
    descent.SetParameterLowerBound(evaluation.scaled(), i, parameter.low / parameter.scale);
    descent.SetParameterUpperBound(evaluation.scaled(), i, parameter.high / parameter.scale);
  }
  Watch watch(problem, evaluation, options, start);
  ceres::Solver::Options how;
  how.linear_solver_type = ceres::DENSE_QR;
  how.max_num_iterations = options.most_iterations;
  how.function_tolerance = 1e-10;
  how.parameter_tolerance = 1e-9;
  how.logging_type = ceres::SILENT;
  how.callbacks.push_back(&watch);
  how.update_state_every_iteration = true;
  ceres::Solver::Summary summary;
  ceres::Solve(how, &descent, &summary);
  fit.stopped = is_stopped(options);
  Reached reached = watch.reached();
  if (!fit.stopped) {
    if (!summary.IsSolutionUsable()) return fit;
    evaluation.PrepareForEvaluation(true, true);
    if (evaluation.possible() && evaluation.whole())
      reached = {evaluation.values(), evaluation.residuals(), evaluation.jacobian(), summary.final_cost};
    else if (!is_stopped(options))
      return fit;
    fit.stopped = is_stopped(options);
  }
  if (reached.value.size() == 0) return fit;
  fit.value = std::move(reached.value);
  fit.residuals = std::move(reached.residuals);
  fit.jacobian = std::move(reached.jacobian);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Parameter& parameter = problem.parameters[static_cast<std::size_t>(i)];
    fit.jacobian.col(i) /= parameter.scale;
    const double room = std::min(fit.value(i) - parameter.low, parameter.high - fit.value(i));
    fit.at_bound.push_back(room < 1e-6 * (parameter.high - parameter.low));
  }
  fit.cost = reached.cost;
  fit.iterations = static_cast<int>(summary.iterations.size()) - 1;
  fit.converged = summary.termination_type == ceres::CONVERGENCE;
  return fit;
}

/// A random start between the bounds, uniform in the logarithm for positive ranges of more than a decade.
Eigen::VectorXd drawn_start(const LeastSquares& problem, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0.1, 0.9);
  Eigen::VectorXd start(static_cast<Eigen::Index>(problem.parameters.size()));
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    const auto& [name, first, low, high, scale] = problem.parameters[static_cast<std::size_t>(i)];
    const double at = share(random);
    start(i) = low > 0 && high > 10 * low ? low * std::pow(high / low, at) : low + at * (high - low);
  }
  return start;
}

}  // namespace

LeastSquaresFit least_squares(const LeastSquares& problem, const LeastSquaresOptions& options) {
  std::mt19937_64 random(1);
  Eigen::VectorXd start(static_cast<Eigen::Index>(problem.parameters.size()));
  for (Eigen::Index i = 0; i < start.size(); ++i)
    start(i) = problem.parameters[static_cast<std::size_t>(i)].start;
  LeastSquaresFit best;
  std::vector<double> costs;
  for (int k = 0; k < options.starts; ++k) {
    if (k > 0) start = drawn_start(problem, random);
    LeastSquaresFit fit = descend(problem, start, options, k, 0);
    if (k == 0 && !(fit.cost < INFINITY) && !is_stopped(options))
      throw SolverError("fit: the model cannot be computed at the first values of the parameters");
    costs.push_back(fit.cost);
    if (k == 0 || fit.cost < best.cost) best = std::move(fit);
    if (is_stopped(options)) break;
  }
  best.stopped = is_stopped(options);
  best.starts = static_cast<int>(costs.size());
  best.agreeing =
      static_cast<int>(std::ranges::count_if(costs, [&](double cost) { return cost <= 1.01 * best.cost; }));
  if (options.robust_beyond > 0 && !best.stopped) {
    const double size = options.robust_beyond *
                        std::sqrt(best.residuals.squaredNorm() / static_cast<double>(best.residuals.size()));
    LeastSquaresFit robust = descend(problem, best.value, options, options.starts, size);
    best.stopped = is_stopped(options);
    if (robust.cost < INFINITY) {
      robust.starts = best.starts;
      robust.agreeing = best.agreeing;
      best = std::move(robust);
    }
  }
  return best;
}

}  // namespace rubsweep::fit
