#include "rubsweep/measurement/scope/repeating_angles.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/measurement/recording/shaft_turns.hpp"

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// Values of the Legendre polynomials of degree 1 to `degree` at places from -1 to 1, each column minus its
/// mean.
Eigen::MatrixXd polynomials(const Eigen::VectorXd& places, int degree) {
  Eigen::MatrixXd values(places.size(), degree);
  for (Eigen::Index i = 0; i < degree; ++i)
    for (Eigen::Index k = 0; k < places.size(); ++k)
      values(k, i) = std::legendre(static_cast<unsigned>(i + 1), places(k));
  return values.rowwise() - values.colwise().mean();
}

/// Samples with a margin at either end, copied from one period away.
std::vector<Complex> with_margins(std::span<const Complex> samples, std::size_t period, std::size_t margin) {
  std::vector<Complex> wide;
  for (std::size_t k = period - margin; k < period; ++k) wide.push_back(samples[k]);
  wide.insert(wide.end(), samples.begin(), samples.end());
  for (std::size_t k = 0; k < margin; ++k) wide.push_back(samples[samples.size() - period + k]);
  return wide;
}

/// Samples at shifted angles. The shift is given, in turns, at the beginning of every turn and at the end of
/// the last one.
std::vector<Complex> shifted(std::span<const Complex> samples, int samples_per_revolution, std::size_t period,
                             const Eigen::VectorXd& shift_turns) {
  std::vector<double> begins;
  for (Eigen::Index turn = 0; turn < shift_turns.size(); ++turn)
    begins.push_back(static_cast<double>(turn) + shift_turns(turn));
  const double largest = shift_turns.cwiseAbs().maxCoeff();
  constexpr std::size_t neighbours = 6;
  const std::size_t margin =
      std::min(period, neighbours + static_cast<std::size_t>(std::ceil(largest * samples_per_revolution)));
  const double first = -static_cast<double>(margin) / samples_per_revolution;
  std::vector<double> x, y;
  for (const Complex z : with_margins(samples, period, margin)) {
    x.push_back(z.real());
    y.push_back(z.imag());
  }
  x = recording::at_equal_angles(x, first, samples_per_revolution, begins, samples_per_revolution);
  y = recording::at_equal_angles(y, first, samples_per_revolution, begins, samples_per_revolution);
  std::vector<Complex> moved;
  for (std::size_t k = 0; k < x.size(); ++k) moved.emplace_back(x[k], y[k]);
  return moved;
}

/// Derivative of a periodic orbit per turn, computed from its lines up to an order.
std::vector<Complex> rate_of(std::span<const Complex> orbit, int turns, double most_order) {
  const int last = std::min(static_cast<int>(most_order * turns), static_cast<int>(orbit.size()) / 2 - 1);
  const std::vector<Complex> lines = lines_of_period(orbit, last);
  std::vector<Complex> rate(orbit.size());
  for (int k = -last; k <= last; ++k) {
    const double order = static_cast<double>(k) / turns;
    const Complex line = lines[static_cast<std::size_t>(k + last)] * Complex(0, 2 * pi * order);
    const Complex step = std::polar(1.0, 2 * pi * static_cast<double>(k) / static_cast<double>(orbit.size()));
    Complex root = 1;
    for (Complex& sum : rate) {
      sum += line * root;
      root *= step;
    }
  }
  return rate;
}

/// Lag of each period behind the mean of all periods, in turns.
Eigen::VectorXd lags(std::span<const Complex> periods, int turns, std::size_t period, double most_order) {
  const std::vector<Complex> orbit = mean_period(periods, period);
  const std::vector<Complex> rate = rate_of(orbit, turns, most_order);
  double energy = 0;
  for (const Complex z : rate) energy += std::norm(z);
  Eigen::VectorXd lags = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(periods.size() / period));
  for (std::size_t k = 0; k < periods.size() && energy > 0; ++k) {
    const std::size_t place = k % period;
    lags(static_cast<Eigen::Index>(k / period)) +=
        std::real(std::conj(rate[place]) * (orbit[place] - periods[k])) / energy;
  }
  return lags;
}

/// Least-squares polynomial of the lags, one lag for the middle of each period of `turns` turns. The last
/// period ends with the recording. Returns the values of the polynomial at the beginnings of all turns.
Eigen::VectorXd polynomial_through(const Eigen::VectorXd& lags, int turns, int degree, Eigen::Index begins) {
  const double half = 0.5 * static_cast<double>(lags.size()) * turns;
  const double middle = static_cast<double>(begins - 1) - half;
  const auto place = [&](double turn) { return (turn - middle) / half; };
  Eigen::VectorXd middles(lags.size()), places(begins);
  for (Eigen::Index k = 0; k < lags.size(); ++k)
    middles(k) = place(middle - half + (static_cast<double>(k) + 0.5) * turns);
  for (Eigen::Index k = 0; k < begins; ++k) places(k) = place(static_cast<double>(k));
  return polynomials(places, degree) * polynomials(middles, degree).colPivHouseholderQr().solve(lags);
}

/// Whether the errors of the marks permit these shifts, up to a common constant.
bool allowed(const Eigen::VectorXd& shift_turns, const recording::AngleDoubt& doubt) {
  double low = -INFINITY, high = INFINITY;
  for (std::size_t k = 0; k < doubt.low_turns.size(); ++k) {
    const double shift = shift_turns(static_cast<Eigen::Index>(k));
    low = std::max(low, doubt.low_turns[k] - shift);
    high = std::min(high, doubt.high_turns[k] - shift);
  }
  return low <= high;
}

/// Largest factor, at most 1, for which the errors of the marks permit the shifts times this factor.
double allowed_share(const Eigen::VectorXd& shift_turns, const recording::AngleDoubt& doubt) {
  if (allowed(shift_turns, doubt)) return 1;
  constexpr int halvings = 20;
  double share = 0;
  for (int k = 1; k <= halvings; ++k)
    if (const double next = share + std::ldexp(1.0, -k); allowed(next * shift_turns, doubt)) share = next;
  return share;
}

constexpr Eigen::Index fewest_levelled = 4;
constexpr double most_drift = 0.5;

Eigen::MatrixXd projection_on(const Eigen::MatrixXd& functions) {
  const Eigen::MatrixXd unit = Eigen::HouseholderQR<Eigen::MatrixXd>(functions).householderQ() *
                               Eigen::MatrixXd::Identity(functions.rows(), functions.cols());
  return unit * unit.transpose();
}

/// Matrix that extracts the slow part of a sequence of values, one value per period, taken about their mean:
/// a polynomial, and cosines of the remainder. A sum of cosines alone converges slowly where the two ends
/// differ; a polynomial of high degree picks up other lines at the ends. Only the part in phase may therefore
/// have a degree above 1.
Eigen::MatrixXd slow_part_of(Eigen::Index count, bool in_phase) {
  const Eigen::Index degree = in_phase ? std::clamp<Eigen::Index>(count / 8, 1, 3) : 1,
                     waves = count / (in_phase ? 4 : 8);
  const auto all = static_cast<double>(count);
  const Eigen::ArrayXd places = Eigen::ArrayXd::LinSpaced(count, 0.5, all - 0.5) / all;
  Eigen::MatrixXd powers(count, degree), cosines(count, waves);
  for (Eigen::Index d = 0; d < degree; ++d) powers.col(d) = (2 * places - 1).pow(static_cast<double>(d + 1));
  for (Eigen::Index d = 0; d < waves; ++d) cosines.col(d) = (pi * static_cast<double>(d + 1) * places).cos();
  powers.rowwise() -= powers.colwise().mean().eval();
  const Eigen::MatrixXd polynomial = projection_on(powers);
  if (waves == 0) return polynomial;
  return polynomial + projection_on(cosines) * (Eigen::MatrixXd::Identity(count, count) - polynomial);
}

/// Slow part of a line's amplitudes. With `in_phase`, only the component in phase with their mean.
Eigen::VectorXcd slow_part(const Eigen::MatrixXd& part_of, const Eigen::VectorXcd& amplitudes,
                           bool in_phase) {
  if (!in_phase) return part_of * amplitudes;
  const Complex phase = std::polar(1.0, std::arg(amplitudes.mean()));
  const Eigen::VectorXd size = (amplitudes * std::conj(phase)).real();
  return (part_of * size) * phase;
}

/// Removes the component of the amplitudes that repeats after `repeats` values, but keeps its mean. Lines of
/// a longer period would appear as such a repetition.
Eigen::VectorXcd without_repetition(const Eigen::VectorXcd& amplitudes, Eigen::Index repeats) {
  Eigen::VectorXcd left = amplitudes.array() + amplitudes.mean();
  for (Eigen::Index first = 0; first < std::min(repeats, left.size()); ++first) {
    const auto same = Eigen::seq(first, Eigen::last, repeats);
    left(same).array() -= amplitudes(same).mean();
  }
  return left;
}

/// Adds line `order` of a period; its amplitude is linear between the middles of neighbouring periods.
void add_line(const Eigen::VectorXcd& amplitudes, int order, std::size_t length, std::span<Complex> sum) {
  const double step = 2 * pi * order / static_cast<double>(length),
               most = static_cast<double>(amplitudes.size() - 2);
  for (std::size_t k = 0; k < sum.size(); ++k) {
    const double place = (static_cast<double>(k) + 0.5) / static_cast<double>(length) - 0.5;
    const double before = std::clamp(std::floor(place), 0.0, most), share = place - before;
    const auto j = static_cast<Eigen::Index>(before);
    sum[k] += ((1 - share) * amplitudes(j) + share * amplitudes(j + 1)) *
              std::polar(1.0, step * static_cast<double>(k % length));
  }
}

}  // namespace

std::span<const Complex> whole_periods(std::span<const Complex> samples, std::size_t period) {
  return samples.last(samples.size() / period * period);
}

std::vector<Complex> mean_period(std::span<const Complex> samples, std::size_t period) {
  std::vector<Complex> mean(period);
  for (std::size_t k = 0; k < samples.size(); ++k) mean[k % period] += samples[k];
  for (Complex& z : mean) z /= static_cast<double>(samples.size() / period);
  return mean;
}

std::vector<Complex> lines_of_period(std::span<const Complex> period, int last) {
  const std::size_t count = period.size();
  std::vector<Complex> roots(count), lines;
  for (std::size_t j = 0; j < count; ++j)
    roots[j] = std::polar(1.0, -2 * pi * static_cast<double>(j) / static_cast<double>(count));
  for (int k = -last; k <= last; ++k) {
    Complex sum = 0;
    const std::size_t step = k < 0 ? count - static_cast<std::size_t>(-k) : static_cast<std::size_t>(k);
    for (std::size_t j = 0, root = 0; j < count; ++j, root = (root + step) % count)
      sum += period[j] * roots[root];
    lines.push_back(sum / static_cast<double>(count));
  }
  return lines;
}

std::vector<Complex> at_repeating_angles(std::span<const Complex> samples, int samples_per_revolution,
                                         int period, double most_order, const recording::AngleDoubt& doubt) {
  constexpr int most_rounds = 20;
  constexpr double small_turns = 1e-9;
  const auto per_turn = static_cast<std::size_t>(samples_per_revolution);
  const std::size_t turns = samples.size() / per_turn, length = static_cast<std::size_t>(period) * per_turn;
  const int degree = std::min(doubt.degree, static_cast<int>(samples.size() / length) - 1);
  std::vector<Complex> moved(samples.begin(), samples.end());
  Eigen::VectorXd shift_turns = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(turns + 1));
  for (int round = 0; round < most_rounds && degree > 0; ++round) {
    const Eigen::VectorXd late = lags(whole_periods(moved, length), period, length, most_order);
    const Eigen::VectorXd added = polynomial_through(late, period, degree, shift_turns.size());
    shift_turns += added;
    shift_turns *= allowed_share(shift_turns, doubt);
    moved = shifted(samples, samples_per_revolution, length, shift_turns);
    if (added.cwiseAbs().maxCoeff() < small_turns) break;
  }
  return moved;
}

Levelled without_slow_modulation(std::span<const Complex> samples, int samples_per_revolution,
                                 const SlowModulation& slow) {
  Levelled levelled{.samples = {samples.begin(), samples.end()}};
  const auto length = static_cast<std::size_t>(slow.period * samples_per_revolution);
  const auto whole = std::span(levelled.samples).last(samples.size() / length * length);
  const auto periods = static_cast<Eigen::Index>(whole.size() / length);
  if (periods < fewest_levelled) return levelled;
  const int last =
      std::min(static_cast<int>(slow.most_order * slow.period), static_cast<int>(length) / 2 - 1);
  Eigen::MatrixXcd amplitudes(periods, 2 * last + 1);
  for (Eigen::Index j = 0; j < periods; ++j) {
    const auto found = lines_of_period(whole.subspan(static_cast<std::size_t>(j) * length, length), last);
    amplitudes.row(j) = Eigen::Map<const Eigen::RowVectorXcd>(found.data(), amplitudes.cols());
  }
  const double energy =
      (amplitudes.squaredNorm() - amplitudes.col(last).squaredNorm()) / static_cast<double>(periods);
  const Eigen::MatrixXd part_of = slow_part_of(periods, slow.in_phase);
  std::vector<Complex> taken(whole.size());
  const double most_of_a_line = std::min(2 * slow.most_modulation, 1.0);
  double squares = 0, refused = 0;
  for (Eigen::Index i = 0; i < amplitudes.cols(); ++i) {
    const Eigen::VectorXcd line = amplitudes.col(i);
    const bool centre = i == last;
    const double bound =
        centre ? most_drift * most_drift * energy : most_of_a_line * most_of_a_line * std::norm(line.mean());
    const Eigen::VectorXcd part =
        slow_part(part_of, slow.repeats > 1 ? without_repetition(line, slow.repeats) : line, slow.in_phase);
    const double square = part.squaredNorm() / static_cast<double>(periods);
    const bool goes = square <= bound;
    if (goes) add_line(part, static_cast<int>(i) - last, length, taken);
    // The drift of the centre is not counted: a drifting gap voltage is no part of the motion.
    if (!centre) (goes ? squares : refused) += square;
  }
  levelled.refused_m = std::sqrt(refused);
  if (!(squares <= slow.most_modulation * slow.most_modulation * energy)) {
    levelled.refused_m = std::sqrt(refused + squares);
    return levelled;
  }
  for (std::size_t k = 0; k < taken.size(); ++k) whole[k] -= taken[k];
  levelled.modulation_m = std::sqrt(squares);
  return levelled;
}

}  // namespace rubsweep::scope
