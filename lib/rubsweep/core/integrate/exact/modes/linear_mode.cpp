#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/core/integrate/exact/modes/mode_flow.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_views.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

using contact::Mode;
using Matrix = Eigen::MatrixXd;

/// Undamped natural frequency of the slowest oscillator.
double slowest(const Matrix& stiffness) {
  return std::sqrt(numerics::dense::eigenvalues(stiffness).cwiseAbs().minCoeff());
}

/// Builds the linear mode of one joint contact mode.
template <int N>
class ModeBuilder {
  /// For large structures long double costs more time than it saves.
  static constexpr bool unrounded = N != Eigen::Dynamic;
  using Number = std::conditional_t<unrounded, long double, double>;
  using LongOrDouble = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
  using Column = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

 public:
  ModeBuilder(const CommonToModes& common, const std::vector<Mode>& modes, const std::vector<bool>& backward)
      : common_(common),
        system_(common.system),
        backward_(backward),
        mode_(std::make_unique<LinearMode<N>>()) {
    mode_->modes = modes;
  }

  std::unique_ptr<LinearMode<N>> build() {
    assemble();
    if (!find_rest()) return nullptr;
    set_steps();
    add_views(common_, backward_, vibration_, *mode_);
    return std::move(mode_);
  }

 private:
  bool open() const {
    for (const Mode mode : mode_->modes) {
      if (mode != Mode::open) return false;
    }
    return true;
  }

  void assemble() {
    LongOrDouble stiffness = system_.stiffness.template cast<Number>(),
                 damping = system_.damping.template cast<Number>();
    constant_ = system_.constant.template cast<Number>();
    for (std::size_t i = 0; i < mode_->modes.size(); ++i) {
      const auto& c = system_.contacts[i];
      const Mode mode = mode_->modes[i];
      if (mode == Mode::open) continue;
      const contact::LinearLaw law = contact::law_of(mode);
      const Number coefficient = law.friction * (backward_[i] ? -1 : 1) * common_.friction[i].coefficient;
      const Column first_push = c.first_push.template cast<Number>(),
                   second_push = c.second_push.template cast<Number>();
      const Column push = Number{c.stiffness} * (Number{law.spring} * first_push + coefficient * second_push);
      const auto first_row = c.first_row.template cast<Number>();
      stiffness -= push * first_row;
      damping -= Number{law.damper * c.damping} * first_push * first_row;
      constant_ -= push * Number{c.clearance};
    }
    mode_->stiffness = stiffness.template cast<double>();
    mode_->damping = damping.template cast<double>();
    mode_->generator = numerics::generator_of(mode_->stiffness, mode_->damping);
    if constexpr (unrounded) {
      mode_->unrounded.stiffness = stiffness;
      mode_->unrounded.damping = damping;
    }
  }

  bool find_rest() {
    const numerics::dense::FullPivotFactors lu(mode_->stiffness);
    if (!lu.invertible() || lu.reciprocal_condition() < 1e-14) return false;
    if constexpr (unrounded) {
      mode_->unrounded.rest = mode_->unrounded.stiffness.fullPivLu().solve(constant_);
      mode_->rest = mode_->unrounded.rest.template cast<double>();
    } else {
      mode_->rest = lu.solve(constant_);
    }
    return true;
  }

  std::optional<numerics::ModalForm> modal_form_in_contact() const {
    if constexpr (unrounded)
      return numerics::modal_form_of_unrounded(mode_->unrounded.stiffness, mode_->unrounded.damping);
    else
      return numerics::modal_form(mode_->stiffness, mode_->damping);
  }

  void set_steps() {
    mode_->fastest_rad_per_s = numerics::dense::spectral_radius(mode_->generator);
    // Both limits affect only the cost, because the bounds are made for any longest step. A vibration of
    // amplitude a and rate w has the bound M = a w^2. For t > 2 / w, M t^2 / 2 exceeds its largest possible
    // rise 2 a, so that steps much longer than a radian of the slowest vibration could not be certified. In
    // contact the fast vibration against the stop ends the mode within a few of its radians, and bounds
    // without a modal form need a grid that is as fine. Of 4, 8, 16, 32, 64 radians, 8 and 16 take the least
    // time in configs/hard_case/one_side.yaml, and 32 and 16 the fewest steps in configs/rotor_kit.yaml.
    mode_->longest_step_s = 1 / slowest(mode_->stiffness);
    if (!open()) mode_->longest_step_s = std::min(mode_->longest_step_s, 16 / mode_->fastest_rad_per_s);
    mode_->longest_steps_per_s = 1 / mode_->longest_step_s;
    auto& form = vibration_.form = open() ? common_.open_form : modal_form_in_contact();
    typename ExactTypes<N>::Flow &basis = vibration_.basis, inverse;
    mode_->paired = form.has_value();
    if (mode_->paired) {
      basis = form->basis;
      inverse = form->inverse;
      set_pairs();
    } else {
      basis.setIdentity(mode_->generator.rows(), mode_->generator.rows());
      inverse = basis;
      mode_->steps = {mode_->generator, mode_->longest_step_s};
      vibration_.flow_bound.emplace(mode_->generator, mode_->longest_step_s, mode_->fastest_rad_per_s);
    }
    if constexpr (unrounded) {
      mode_->unrounded.basis = form ? form->unrounded_basis : basis.template cast<long double>();
      mode_->unrounded.inverse = form ? form->unrounded_inverse : inverse.template cast<long double>();
    }
    mode_->diagonal_basis = basis.isDiagonal(0) && inverse.isDiagonal(0);
    mode_->basis = typename ExactTypes<N>::Factor(basis);
    mode_->inverse = typename ExactTypes<N>::Factor(inverse);
  }

  void set_pairs() {
    const std::vector<numerics::Pair>& pairs = vibration_.form->pairs;
    mode_->pairs.resize(system_.coordinates(), 4);
    for (Eigen::Index j = 0; j < system_.coordinates(); ++j) {
      const numerics::Pair& g = pairs[static_cast<std::size_t>(j)];
      mode_->pairs.row(j) << g.uu, g.uv, g.vu, g.vv;
    }
    const numerics::PairSeries series = numerics::pair_series(pairs, mode_->fastest_rad_per_s);
    mode_->unit_terms = series.unit;
    mode_->generator_terms = series.generator;
    for (int k = 0; k < numerics::exact_step_count; ++k)
      mode_->pair_steps.push_back(
          flow_of_pairs(*mode_, mode_->longest_step_s * numerics::exact_step_size(k)));
  }

  const CommonToModes& common_;
  const run::ScaledSystem<Eigen::Dynamic>& system_;
  const std::vector<bool>& backward_;
  std::unique_ptr<LinearMode<N>> mode_;
  Column constant_;
  FreeVibration<N> vibration_;
};

}  // namespace

template <int N>
std::unique_ptr<LinearMode<N>> make_linear_mode(const CommonToModes& common, const std::vector<Mode>& modes,
                                                const std::vector<bool>& backward) {
  return ModeBuilder<N>(common, modes, backward).build();
}

template std::unique_ptr<LinearMode<2>> make_linear_mode<2>(const CommonToModes&, const std::vector<Mode>&,
                                                            const std::vector<bool>&);
template std::unique_ptr<LinearMode<4>> make_linear_mode<4>(const CommonToModes&, const std::vector<Mode>&,
                                                            const std::vector<bool>&);
template std::unique_ptr<LinearMode<6>> make_linear_mode<6>(const CommonToModes&, const std::vector<Mode>&,
                                                            const std::vector<bool>&);
template std::unique_ptr<LinearMode<Eigen::Dynamic>> make_linear_mode<Eigen::Dynamic>(
    const CommonToModes&, const std::vector<Mode>&, const std::vector<bool>&);

}  // namespace rubsweep::integrate::exact::modes
