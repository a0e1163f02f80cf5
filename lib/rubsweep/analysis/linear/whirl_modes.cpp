#include "rubsweep/analysis/linear/whirl_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "rubsweep/core/numerics/spectral/decompositions.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"
#include "rubsweep/core/structure/stability.hpp"

namespace rubsweep::linear {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

FreeRotor free_jeffcott(const model::JeffcottRotor& rotor) {
  const structure::Assembly assembly = structure::assemble_jeffcott(rotor, {});
  const structure::LinearSystem& disc = assembly.system;
  FreeRotor free;
  free.full.system = {disc.mass, disc.damping, Eigen::Matrix2d::Zero(), disc.stiffness, {1, 1}};
  free.full.circulatory = assembly.circulatory;
  free.spin = Eigen::Matrix2d{{0, rotor.mass_kg}, {-rotor.mass_kg, 0}};
  free.position_m = {0};
  free.x = Eigen::RowVector2d(1, 0);
  free.y = Eigen::RowVector2d(0, 1);
  return free;
}

FreeRotor free_kit(const model::RotorKit& kit, const std::vector<model::Stop>& stops) {
  std::vector<double> stations_m;
  for (const model::Stop& stop : stops) stations_m.push_back(*stop.position_m);
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(kit, stations_m);
  FreeRotor free;
  free.full = structure::full_system(shaft, kit);
  free.position_m = shaft.node_position_m;
  const structure::LateralSystem& system = free.full.system;
  const Eigen::Index n = system.coordinates(), nodes = static_cast<Eigen::Index>(free.position_m.size());
  free.x = free.y = Eigen::MatrixXd::Zero(nodes, n);
  for (Eigen::Index node = 0; node < nodes; ++node) {
    free.x(node, system.index(0, 2 * node)) = 1;
    free.y(node, system.index(1, 2 * node)) = 1;
  }
  // If the masses of the two planes differ, their mean is used.
  const Eigen::MatrixXd mass = (shaft.plane_mass(0) + shaft.plane_mass(1)) / 2;
  free.spin = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < mass.rows(); ++i) {
    for (Eigen::Index k = 0; k < mass.cols(); ++k) {
      free.spin(system.index(0, i), system.index(1, k)) = mass(i, k);
      free.spin(system.index(1, i), system.index(0, k)) = -mass(i, k);
    }
  }
  return free;
}

constexpr double same_root = 1e-7;    ///< roots closer than this share of their size count as equal
constexpr double least_whirl = 1e-7;  ///< roots with a smaller share of imaginary part do not whirl

bool whirls(Complex root) { return root.imag() > least_whirl * std::abs(root); }

bool inside(Complex root, const structure::RateDisc& disc) {
  return std::abs(root - disc.centre) <= disc.radius;
}

/// Positive definite mass matrix: coordinates without mass get a very small mass.
Eigen::MatrixXd with_mass(Eigen::MatrixXd mass) {
  constexpr double hardly_any = 1e-9;
  const double largest = mass.diagonal().maxCoeff();
  for (Eigen::Index i = 0; i < mass.rows(); ++i)
    if (mass.row(i).isZero(0)) mass(i, i) = hardly_any * largest;
  return mass;
}

/// Sets the real part of a root to 0 if its growth may be caused by rounding.
void drop_rounding(const structure::SpeedMatrices& matrices, bool dissipates, const Eigen::VectorXcd& shape,
                   Complex& root) {
  if (!(root.real() > 0)) return;
  if (dissipates || root.real() <= structure::rate_rounding_per_s(matrices, root, shape))
    root = {0, root.imag()};
}

bool never_grows(const structure::SpeedMatrices& matrices) {
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  return structure::dissipates(matrices.mass, matrices.damping, matrices.stiffness, rounding);
}

/// Roots at one speed that a diagram must show, wherever they lie in the complex plane: whirl up to
/// `fastest`, the two slowest whirls, and all growing motions.
std::vector<Complex> wanted_rates(const structure::SpeedMatrices& matrices, double fastest) {
  constexpr std::size_t slowest = 2;
  // Larger rates belong to single elements; smaller growth may be rounding.
  constexpr double far = 1e3, growth = 1e-7;
  const bool dissipating = never_grows(matrices);
  std::vector<Complex> found, wanted;
  for (const Complex root : structure::all_rates_per_s(matrices, 4 * fastest)) {
    if (whirls(root)) found.push_back(root);
    if (!dissipating && root.imag() >= 0 && std::abs(root) < far * fastest &&
        root.real() > growth * std::abs(root))
      wanted.push_back(root);
  }
  std::ranges::sort(found, {}, [](Complex root) { return root.imag(); });
  for (std::size_t k = 0; k < found.size(); ++k)
    if (k < slowest || found[k].imag() <= fastest) wanted.push_back(found[k]);
  return wanted;
}

/// Indices of the speeds at which all roots are computed. The cost grows with the third power of the number
/// of states; all these speeds together take about 1 s.
std::vector<std::size_t> looked_at(std::size_t speeds, Eigen::Index states) {
  constexpr double a_second = 3e8;
  const double affordable = a_second / std::pow(static_cast<double>(states), 3);
  const std::size_t count = std::min(speeds, static_cast<std::size_t>(std::clamp(affordable, 3.0, 1e4)));
  std::vector<std::size_t> places{0};
  for (std::size_t i = 1; i < count; ++i) places.push_back(i * (speeds - 1) / (count - 1));
  return places;
}

/// Strongly damped whirl up to `fastest` at one speed, outside the disc around 0 with the radius 4 `fastest`.
/// Searches overlapping discs along the negative real axis, up to a thousand times `fastest`.
std::vector<Complex> strongly_damped_rates(const structure::SpeedMatrices& matrices, double fastest) {
  constexpr double first = 8, last = 1e3, ratio = 4.5, radius = 0.7;
  std::vector<Complex> found;
  for (double centre = first * fastest; centre < last * fastest; centre *= ratio) {
    for (const Complex root : structure::free_modes(matrices, {-centre, radius * centre}).rate_per_s)
      if (whirls(root) && root.imag() <= fastest) found.push_back(root);
  }
  return found;
}

}  // namespace

FreeRotor free_rotor(const model::Machine& machine) {
  return std::visit(overloaded{[](const model::JeffcottRotor& rotor) { return free_jeffcott(rotor); },
                               [&](const model::RotorKit& kit) { return free_kit(kit, machine.stops); }},
                    machine.rotor);
}

double WhirlMode::frequency_hz() const { return root_per_s.imag() / (2 * pi); }

double WhirlMode::damping_ratio() const {
  return root_per_s.real() == 0 ? 0 : -root_per_s.real() / std::abs(root_per_s);
}

double assurance(const WhirlMode& a, const WhirlMode& b) { return std::norm(a.state.dot(b.state)); }

WhirlProblem::WhirlProblem(const FreeRotor& rotor, std::span<const double> speeds_hz, double up_to_hz)
    : full_(rotor.full),
      mass_(with_mass(full_.system.mass)),
      spin_(Complex(0, 1) * rotor.spin.cast<Complex>()) {
  const double fastest = 2 * pi * up_to_hz;
  discs_ = {{0, 4 * fastest}};
  std::vector<Complex> wanted;
  const auto places = looked_at(speeds_hz.size(), 2 * full_.system.coordinates());
  for (std::size_t place = 0; place < speeds_hz.size(); ++place) {
    const structure::SpeedMatrices now = matrices(speeds_hz[place]);
    for (const Complex root : std::ranges::binary_search(places, place)
                                  ? wanted_rates(now, fastest)
                                  : strongly_damped_rates(now, fastest)) {
      if (std::abs(root) <= 2 * root.imag() || root.real() > 0) {
        discs_.front().radius = std::max(discs_.front().radius, 1.5 * std::abs(root));
      } else {
        wanted.push_back(root);
      }
    }
  }
  // Roots with almost no oscillation lie far to the left of the others and need separate discs.
  for (const Complex root : wanted) {
    if (std::ranges::none_of(discs_, [&](const auto& disc) { return inside(root, disc); }))
      discs_.push_back({root.real(), std::max(2 * fastest, 0.3 * std::abs(root.real()))});
  }
}

structure::SpeedMatrices WhirlProblem::matrices(double speed_hz) const {
  const double speed = 2 * pi * speed_hz;
  return structure::matrices_at(full_, speed, speed);
}

WhirlModes WhirlProblem::at(double speed_hz) const {
  const structure::SpeedMatrices now = matrices(speed_hz);
  const bool dissipating = never_grows(now);
  WhirlModes whirl;
  std::vector<WhirlMode>& modes = whirl.modes;
  for (std::size_t d = 0; d < discs_.size(); ++d) {
    const structure::FreeModes found = structure::free_modes(now, discs_[d]);
    for (Eigen::Index k = 0; k < found.rate_per_s.size(); ++k) {
      Complex root = found.rate_per_s(k);
      const bool known = std::any_of(discs_.begin(), discs_.begin() + static_cast<std::ptrdiff_t>(d),
                                     [&](const auto& disc) { return inside(root, disc); });
      if (known || root.imag() < 0) continue;
      drop_rounding(now, dissipating, found.shape.col(k), root);
      whirl.growth_per_s = std::max(whirl.growth_per_s, root.real());
      if (whirls(root)) modes.push_back(mode_of(root, found.shape.col(k), now.mass));
    }
  }
  std::ranges::stable_sort(modes, {}, [](const WhirlMode& mode) { return mode.root_per_s.imag(); });
  part_by_direction(modes, now.mass);
  return whirl;
}

std::optional<WhirlMode> WhirlProblem::continued(const WhirlMode& mode, double speed_hz) const {
  constexpr double certain = 0.5;
  const structure::SpeedMatrices now = matrices(speed_hz);
  Complex root = mode.root_per_s;
  Eigen::VectorXcd shape = mode.shape.normalized();
  if (!structure::follow_free_mode(now, root, shape) || !whirls(root)) return std::nullopt;
  drop_rounding(now, never_grows(now), shape, root);
  WhirlMode found = mode_of(root, shape, now.mass);
  return assurance(found, mode) > certain ? std::optional(std::move(found)) : std::nullopt;
}

WhirlMode WhirlProblem::mode_of(Complex root, const Eigen::VectorXcd& shape,
                                const Eigen::MatrixXd& mass) const {
  WhirlMode mode;
  mode.root_per_s = root;
  mode.state = (mass_.upper().cast<Complex>() * shape);
  const double length = mode.state.norm();
  mode.state /= length;
  mode.shape = shape / length;
  const double forward_less_backward = mode.shape.dot(spin_ * mode.shape).real();
  const double both = mode.shape.dot(mass * mode.shape).real();
  mode.forward_share = std::clamp(0.5 * (1 + forward_less_backward / both), 0.0, 1.0);
  return mode;
}

void WhirlProblem::part_by_direction(std::vector<WhirlMode>& modes, const Eigen::MatrixXd& mass) const {
  for (std::size_t begin = 0, end = 0; begin < modes.size(); begin = end) {
    const Complex root = modes[begin].root_per_s;
    while (end < modes.size() && std::abs(modes[end].root_per_s - root) <= same_root * std::abs(root)) ++end;
    const auto count = static_cast<Eigen::Index>(end - begin);
    if (count < 2) continue;
    Eigen::MatrixXcd states(spin_.rows(), count);
    for (Eigen::Index k = 0; k < count; ++k) states.col(k) = modes[begin + static_cast<std::size_t>(k)].state;
    const Eigen::MatrixXcd base = numerics::spectral::unitary_columns(states, count);
    Eigen::MatrixXcd shapes(base.rows(), count);
    shapes.real() = mass_.solve_upper(base.real());
    shapes.imag() = mass_.solve_upper(base.imag());
    // Sorted from most backward to most forward.
    const auto directions =
        numerics::spectral::hermitian_modes(Eigen::MatrixXcd(shapes.adjoint() * spin_ * shapes));
    const Eigen::MatrixXcd parted = shapes * directions.vectors;
    for (Eigen::Index k = 0; k < count; ++k) {
      WhirlMode& mode = modes[begin + static_cast<std::size_t>(k)];
      mode = mode_of(mode.root_per_s, parted.col(k), mass);
    }
  }
}

}  // namespace rubsweep::linear
