#include "rubsweep/analysis/linear/bode.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>

namespace rubsweep::linear {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr std::size_t fewest_samples = 8;

/// Phasor A of the least-squares fit offset + Re(A e^{i angle}).
Complex fit_phasor(std::span<const double> x, std::span<const double> angle) {
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixX3d base(n, 3);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double phi = angle[static_cast<std::size_t>(k)];
    base.row(k) << std::cos(phi), -std::sin(phi), 1;
  }
  const Eigen::Vector3d fit =
      base.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(x.data(), n));
  return {fit(0), fit(1)};
}

double lag_deg(Complex phasor, double sensor_angle_deg) {
  double phase = std::arg(phasor) * 180 / pi + sensor_angle_deg;
  phase -= 360 * std::ceil(phase / 360 - 1e-12);
  // With noise, a lag of zero shall read about 0, not about -360.
  return phase <= -350 ? phase + 360 : phase;
}

/// Middle of a window, and the noise that remains in it.
struct Window {
  std::size_t middle = 0;
  Complex noise_m;
};

std::vector<Window> windows_of(const OneXSignal& signal, int revolutions) {
  const std::span<const double> angle = signal.shaft_angle_rad;
  const auto reaching = [&](double target_rad) {
    return static_cast<std::size_t>(std::ranges::lower_bound(angle, target_rad) - angle.begin());
  };
  std::vector<Window> windows;
  for (long turn = 0;; ++turn) {
    const double begin_rad = angle.empty() ? 0 : angle.front() + 2 * pi * static_cast<double>(turn);
    const std::size_t begin = reaching(begin_rad), end = reaching(begin_rad + 2 * pi * revolutions);
    if (end >= angle.size()) break;  // no whole window remains
    if (end - begin < fewest_samples) continue;
    Window window{reaching(begin_rad + pi * revolutions), 0};
    if (!windows.empty() && windows.back().middle == window.middle) continue;
    if (!signal.noise_m.empty())
      window.noise_m =
          fit_phasor(signal.noise_m.subspan(begin, end - begin), angle.subspan(begin, end - begin));
    windows.push_back(window);
  }
  return windows;
}

/// Finds the largest amplitude between the neighbours of a window, by a parabola through the samples.
void find_top(const OneXSignal& signal, const Window& before, const Window& at, const Window& after,
              OneX& one) {
  const auto amplitude = [&](std::size_t k) { return std::abs(signal.phasor_m[k] + at.noise_m); };
  std::size_t top = at.middle;
  for (std::size_t k = before.middle; k <= after.middle; ++k) {
    if (amplitude(k) > amplitude(top)) top = k;
  }
  top = std::clamp<std::size_t>(top, before.middle + 1, after.middle - 1);
  const double a = amplitude(top - 1), b = amplitude(top), c = amplitude(top + 1), bend = a - 2 * b + c;
  const double shift = bend < 0 ? std::clamp((a - c) / (2 * bend), -1.0, 1.0) : 0;
  one.largest_amplitude_m = b - (a - c) * shift / 4;
  // From sample to sample the speed changes at a constant rate.
  one.speed_of_largest_hz = signal.speed_hz[top] + shift * (signal.speed_hz[top + 1] - signal.speed_hz[top]);
}

constexpr double lowest_share = 0.25;
constexpr std::size_t fewest_points = 16;
constexpr std::size_t most_points = 600;

/// 1X on a ramp with the shaft angle phi = 2 pi (from t + rate t^2 / 2): phasors A of the part Re(A e^{i
/// phi}).
struct RampedOneX {
  double from_hz = 0, rate_hz_per_s = 0;
  Eigen::VectorXd t_s;
  Eigen::VectorXcd phasor_m;

  double angle_rad(double t) const { return 2 * pi * (from_hz * t + rate_hz_per_s * t * t / 2); }
  double speed(double t) const { return 2 * pi * (from_hz + rate_hz_per_s * t); }
};

/// Part around the largest amplitude in which the amplitude stays above `lowest_share` of the largest; a long
/// part is thinned.
RampedOneX stretch_about_top(std::span<const BodePoint> plot, double rate_hz_per_s) {
  const auto top = std::ranges::max_element(plot, {}, &BodePoint::amplitude_m);
  const auto low = [&](const BodePoint& point) {
    return point.amplitude_m < lowest_share * top->amplitude_m;
  };
  const auto end = std::find_if(top, plot.end(), low);
  const auto begin = std::find_if(std::make_reverse_iterator(top), plot.rend(), low).base();
  const auto count = static_cast<std::size_t>(end - begin);
  const std::size_t stride = std::max<std::size_t>(1, count / most_points);
  RampedOneX data{.from_hz = begin->speed_hz, .rate_hz_per_s = rate_hz_per_s, .t_s = {}, .phasor_m = {}};
  const auto kept = static_cast<Eigen::Index>((count + stride - 1) / stride);
  data.t_s.resize(kept);
  data.phasor_m.resize(kept);
  for (Eigen::Index k = 0; k < kept; ++k) {
    const BodePoint& point = begin[k * static_cast<Eigen::Index>(stride)];
    data.t_s(k) = (point.speed_hz - data.from_hz) / rate_hz_per_s;
    data.phasor_m(k) = std::polar(point.amplitude_m, point.phase_deg * pi / 180);
  }
  return data;
}

struct GaussNode {
  double place, weight;  ///< places in 0..1
};
/// Gauss-Legendre rule with eight points. Over 8 rad of phase its error is 2e-13.
constexpr std::array<GaussNode, 8> gauss{{{0.019855071751231884, 0.050614268145188130},
                                          {0.101666761293186630, 0.111190517226687235},
                                          {0.237233795041835507, 0.156853322938943644},
                                          {0.408282678752175098, 0.181341891689180991},
                                          {0.591717321247824902, 0.181341891689180991},
                                          {0.762766204958164493, 0.156853322938943644},
                                          {0.898333238706813370, 0.111190517226687235},
                                          {0.980144928248768116, 0.050614268145188130}}};
constexpr double longest_step_rad = 8;

/// Responses of a pole at each point: to an unbalance, to a bow, and its free vibration from t = 0 on.
using PoleColumns = Eigen::MatrixX3cd;

/// Solutions of A' = (pole - i phi') A + f at all points: from A = 0 with f = phi'^2 - i phi'' (unbalance)
/// and f = 1 (bow), and from A = 1 with f = 0.
PoleColumns pole_columns(const RampedOneX& data, Complex pole) {
  PoleColumns columns(data.t_s.size(), 3);
  Eigen::RowVector3cd at(0, 0, 1);
  columns.row(0) = at;
  const double turning = 2 * pi * data.rate_hz_per_s;
  for (Eigen::Index k = 1; k < data.t_s.size(); ++k) {
    const double from = data.t_s(k - 1), to = data.t_s(k);
    const double fastest =
        std::max(std::abs(pole - Complex(0, data.speed(from))), std::abs(pole - Complex(0, data.speed(to))));
    const int steps = std::max(1, static_cast<int>(std::ceil(fastest * (to - from) / longest_step_rad)));
    const double h = (to - from) / steps;
    for (int step = 0; step < steps; ++step) {
      const double end = from + (step + 1) * h, end_rad = data.angle_rad(end);
      const auto flow = [&](double t) {
        return std::exp(pole * (end - t) - Complex(0, end_rad - data.angle_rad(t)));
      };
      at *= flow(end - h);
      for (const GaussNode& node : gauss) {
        const double t = end - h + node.place * h, speed = data.speed(t);
        const Complex part = node.weight * h * flow(t);
        at(0) += part * Complex(speed * speed, -turning);
        at(1) += part;
      }
    }
    columns.row(k) = at;
  }
  return columns;
}

/// Columns of the linear fit of 1X: response of the mode to unbalance and bow, its free vibration forward and
/// backward, and other modes, which follow the speed without resonance.
Eigen::MatrixXcd columns_of(const RampedOneX& data, const Eigen::Vector2d& log_frequency_and_damping) {
  const double w = std::exp(log_frequency_and_damping(0)), ratio = std::exp(log_frequency_and_damping(1));
  const Complex pole = w * Complex(-ratio, std::sqrt(1 - ratio * ratio));
  const PoleColumns forward = pole_columns(data, pole), backward = pole_columns(data, std::conj(pole));
  Eigen::MatrixXcd columns(data.t_s.size(), 6);
  columns.leftCols<2>() = (forward.leftCols<2>() - backward.leftCols<2>()) / (pole - std::conj(pole));
  columns.col(1) *= w * w;
  columns.col(2) = forward.col(2);
  columns.col(3) = backward.col(2);
  for (Eigen::Index k = 0; k < columns.rows(); ++k) {
    const double s = data.speed(data.t_s(k)) / w;
    columns(k, 4) = 1;
    columns(k, 5) = s * s;
  }
  return columns;
}

constexpr double largest_log_ratio = -1e-3, smallest_log_ratio = -14;

/// Part of 1X that remains after the best linear combination of the columns; real parts, then imaginary ones.
Eigen::VectorXd residual(const RampedOneX& data, Eigen::Vector2d p) {
  p(1) = std::clamp(p(1), smallest_log_ratio, largest_log_ratio);
  const Eigen::MatrixXcd columns = columns_of(data, p);
  const Eigen::VectorXcd r = data.phasor_m - columns * columns.colPivHouseholderQr().solve(data.phasor_m);
  Eigen::VectorXd parts(2 * r.size());
  parts << r.real(), r.imag();
  return parts;
}

/// Start of the fit: the best point of a grid over the speeds of the part and over damping ratios.
Eigen::Vector2d best_start(const RampedOneX& data) {
  const double first = data.speed(0), last = data.speed(data.t_s(data.t_s.size() - 1));
  constexpr int frequencies = 24;
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= frequencies; ++i) {
    for (const double ratio : {0.001, 0.004, 0.015, 0.06, 0.2}) {
      const Eigen::Vector2d p(std::log(first + (last - first) * i / frequencies), std::log(ratio));
      const double error = residual(data, p).squaredNorm();
      if (error < least) {
        least = error;
        best = p;
      }
    }
  }
  return best;
}

/// Levenberg-Marquardt iteration with central differences.
Eigen::Vector2d refine(const RampedOneX& data, Eigen::Vector2d p) {
  constexpr double h = 1e-5;
  constexpr int most_iterations = 60;
  Eigen::VectorXd r = residual(data, p);
  double damping = 1e-3;
  for (int iteration = 0; iteration < most_iterations && damping < 1e12; ++iteration) {
    Eigen::MatrixX2d jacobian(r.size(), 2);
    for (Eigen::Index i = 0; i < 2; ++i) {
      const Eigen::Vector2d shift = h * Eigen::Vector2d::Unit(i);
      jacobian.col(i) = (residual(data, p + shift) - residual(data, p - shift)) / (2 * h);
    }
    Eigen::Matrix2d normal = jacobian.transpose() * jacobian;
    normal.diagonal() *= 1 + damping;
    const Eigen::Vector2d step = normal.inverse() * (jacobian.transpose() * r);
    Eigen::VectorXd trial = residual(data, p - step);
    if (trial.squaredNorm() < r.squaredNorm()) {
      p -= step;
      r = std::move(trial);
      damping /= 10;
      if (step.norm() < 1e-10) break;
    } else {
      damping *= 10;
    }
  }
  return p;
}

}  // namespace

OneX one_x(const OneXSignal& signal, int revolutions) {
  const std::vector<Window> windows = windows_of(signal, revolutions);
  OneX one;
  std::size_t top = 0;
  for (const Window& window : windows) {
    const Complex phasor = signal.phasor_m[window.middle] + window.noise_m;
    one.plot.push_back(
        {signal.speed_hz[window.middle], std::abs(phasor), lag_deg(phasor, signal.sensor_angle_deg)});
    if (one.plot.back().amplitude_m > one.plot[top].amplitude_m) top = one.plot.size() - 1;
  }
  if (one.plot.empty()) return one;
  one.largest_amplitude_m = one.plot[top].amplitude_m;
  const bool inside = top > 0 && top + 1 < windows.size();
  if (inside) find_top(signal, windows[top - 1], windows[top], windows[top + 1], one);
  return one;
}

std::optional<RampResonance> fit_ramp_resonance(std::span<const BodePoint> plot, double rate_hz_per_s) {
  if (plot.empty()) return std::nullopt;
  const RampedOneX data = stretch_about_top(plot, rate_hz_per_s);
  const Eigen::Index last = data.t_s.size() - 1;
  if (data.t_s.size() < static_cast<Eigen::Index>(fewest_points)) return std::nullopt;
  if (!((data.t_s.tail(last) - data.t_s.head(last)).minCoeff() > 0)) return std::nullopt;
  const double energy = data.phasor_m.squaredNorm();
  if (!(energy > 0)) return std::nullopt;
  const Eigen::Vector2d p = refine(data, best_start(data));
  const double first_hz = data.from_hz, last_hz = first_hz + rate_hz_per_s * data.t_s(last);
  const double frequency_hz = std::exp(p(0)) / (2 * pi);
  const bool inside =
      frequency_hz > std::min(first_hz, last_hz) && frequency_hz < std::max(first_hz, last_hz);
  if (!inside || !(p(1) > smallest_log_ratio && p(1) < largest_log_ratio)) return std::nullopt;
  return RampResonance{.frequency_hz = frequency_hz,
                       .damping_ratio = std::exp(p(1)),
                       .misfit = std::sqrt(residual(data, p).squaredNorm() / energy),
                       .from_hz = first_hz,
                       .to_hz = last_hz};
}

}  // namespace rubsweep::linear
