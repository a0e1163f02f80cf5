#include "rubsweep/analysis/design/damped_stability.hpp"

#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <numbers>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::design {
namespace {

using std::numbers::pi;

void couple(Eigen::MatrixXd& stiffness, const linear::FreeRotor& rotor, Eigen::Index place,
            double coupling_n_per_m) {
  const Eigen::RowVectorXd x = rotor.x.row(place), y = rotor.y.row(place);
  stiffness += coupling_n_per_m * (x.transpose() * y - y.transpose() * x);
}

/// First forward whirl of at most `up_to_hz`; the problem may know faster ones.
std::optional<linear::WhirlMode> forward_mode(const linear::WhirlProblem& problem, double speed_hz,
                                              double up_to_hz) {
  constexpr double gone_before_it_comes_round = 0.5;
  for (linear::WhirlMode& mode : problem.at(speed_hz).modes) {
    if (mode.frequency_hz() > up_to_hz) break;
    if (mode.forward_share > 0.5 && mode.damping_ratio() < gone_before_it_comes_round) return std::move(mode);
  }
  return std::nullopt;
}

double decrement_of(const linear::WhirlMode& mode) {
  return -2 * pi * mode.root_per_s.real() / mode.root_per_s.imag();
}

/// Makes `mode` the whirl that continues it under another coupling; false where it is lost.
bool continues_under(const structure::SpeedMatrices& without, const linear::FreeRotor& rotor,
                     Eigen::Index place, double coupling_n_per_m, linear::WhirlMode& mode) {
  constexpr double precision = 1e-11;  // the rounding of shaft elements is only slightly smaller
  structure::SpeedMatrices matrices = without;
  couple(matrices.stiffness, rotor, place, coupling_n_per_m);
  return structure::follow_free_mode(matrices, mode.root_per_s, mode.shape, precision);
}

/// Growth rate of the whirl `mode` under another coupling; `mode` becomes the whirl under this coupling.
double growth_under(const structure::SpeedMatrices& without, const linear::FreeRotor& rotor,
                    Eigen::Index place, double coupling_n_per_m, linear::WhirlMode& mode) {
  if (!continues_under(without, rotor, place, coupling_n_per_m, mode))
    throw SolverError("design check: the first forward whirl is lost as cross-coupling grows");
  return mode.root_per_s.real();
}

}  // namespace

double cross_coupling_n_per_m(const Stage& stage, double speed_hz) {
  const double factor = stage.axial ? 1.5 : 3;
  return factor * stage.power_w * stage.density_ratio /
         (2 * pi * speed_hz * stage.diameter_m * stage.width_m);
}

double region_limit(double gas_density_kg_per_m3) {
  constexpr double light_gas = 16.53, heavy_gas = 60;
  if (gas_density_kg_per_m3 <= light_gas) return 2.5;
  return gas_density_kg_per_m3 <= heavy_gas ? 2.69 - 0.0115 * gas_density_kg_per_m3 : 0;
}

std::optional<Decrement> first_forward(const linear::FreeRotor& rotor, std::span<const double> speeds_hz,
                                       double up_to_hz, Eigen::Index place, double coupling_n_per_m) {
  linear::FreeRotor coupled = rotor;
  if (coupling_n_per_m != 0) couple(coupled.full.system.stiffness, rotor, place, coupling_n_per_m);
  const linear::WhirlProblem problem(coupled, speeds_hz, up_to_hz);
  std::optional<Decrement> least;
  for (const double speed_hz : speeds_hz) {
    const auto mode = forward_mode(problem, speed_hz, up_to_hz);
    if (!mode) continue;
    const double decrement = decrement_of(*mode);
    if (!least || decrement < least->decrement) least = Decrement{speed_hz, mode->frequency_hz(), decrement};
  }
  return least;
}

std::vector<Decrement> over_coupling(const linear::FreeRotor& rotor, double speed_hz, double up_to_hz,
                                     Eigen::Index place, std::span<const double> couplings_n_per_m) {
  const std::vector<double> speeds{speed_hz};
  auto mode = forward_mode(linear::WhirlProblem(rotor, speeds, up_to_hz), speed_hz, up_to_hz);
  if (!mode) return {};
  const double w = 2 * pi * speed_hz;
  const structure::SpeedMatrices without = structure::matrices_at(rotor.full, w, w);
  std::vector<Decrement> decrements;
  for (const double coupling : couplings_n_per_m) {
    if (!continues_under(without, rotor, place, coupling, *mode) || mode->root_per_s.imag() <= 0) break;
    decrements.push_back({speed_hz, mode->frequency_hz(), decrement_of(*mode)});
  }
  return decrements;
}

std::optional<double> threshold_n_per_m(const linear::FreeRotor& rotor, double speed_hz, double up_to_hz,
                                        Eigen::Index place) {
  constexpr double first_n_per_m = 1, most_n_per_m = 1e12;
  const std::vector<double> speeds{speed_hz};
  std::optional<linear::WhirlMode> mode =
      forward_mode(linear::WhirlProblem(rotor, speeds, up_to_hz), speed_hz, up_to_hz);
  if (!mode) return std::nullopt;
  double growth = mode->root_per_s.real();
  if (growth >= 0) return 0;
  const double w = 2 * pi * speed_hz;
  const structure::SpeedMatrices without = structure::matrices_at(rotor.full, w, w);
  for (double low = 0, high = first_n_per_m; high <= most_n_per_m; low = high, high *= 2) {
    linear::WhirlMode next = *mode;
    const double grown = growth_under(without, rotor, place, high, next);
    if (grown > 0) {
      const auto by_coupling = [&](double coupling) {
        linear::WhirlMode between = *mode;
        return growth_under(without, rotor, place, coupling, between);
      };
      std::uintmax_t iterations = 100;
      const auto bracket = boost::math::tools::toms748_solve(
          by_coupling, low, high, growth, grown, boost::math::tools::eps_tolerance<double>(44), iterations);
      return bracket.first + (bracket.second - bracket.first) / 2;
    }
    growth = grown;
    mode = std::move(next);
  }
  return std::nullopt;
}

}  // namespace rubsweep::design
