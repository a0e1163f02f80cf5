#include "rubsweep/measurement/scope/slow_modulation.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/measurement/scope/repeating_angles.hpp"

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr Eigen::Index fewest_levelled = 4;
constexpr double most_drift = 0.5;

Eigen::MatrixXd projection_on(const Eigen::MatrixXd& functions) {
  const Eigen::MatrixXd unit = Eigen::HouseholderQR<Eigen::MatrixXd>(functions).householderQ() *
                               Eigen::MatrixXd::Identity(functions.rows(), functions.cols());
  return unit * unit.transpose();
}

/// Matrix that leaves the slow part of the values of so many periods about their mean: a polynomial, and
/// cosines of what is left. Cosines come slowly to what does not end as it began, and a polynomial takes
/// other lines along at the ends: only what is in phase may have more than a straight line.
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

/// Slow part of a line's amplitudes; in phase with their mean alone, if that is asked for.
Eigen::VectorXcd slow_part(const Eigen::MatrixXd& part_of, const Eigen::VectorXcd& amplitudes,
                           bool in_phase) {
  if (!in_phase) return part_of * amplitudes;
  const Complex phase = std::polar(1.0, std::arg(amplitudes.mean()));
  const Eigen::VectorXd size = (amplitudes * std::conj(phase)).real();
  return (part_of * size) * phase;
}

/// Amplitudes without what comes again after so many of them, but for its mean: the lines of a longer period
/// alias into those of a turn.
Eigen::VectorXcd without_repetition(const Eigen::VectorXcd& amplitudes, Eigen::Index repeats) {
  Eigen::VectorXcd left = amplitudes.array() + amplitudes.mean();
  for (Eigen::Index first = 0; first < std::min(repeats, left.size()); ++first) {
    const auto same = Eigen::seq(first, Eigen::last, repeats);
    left(same).array() -= amplitudes(same).mean();
  }
  return left;
}

/// Adds line `order` of a period with an amplitude that is a straight line between the middles of two
/// periods.
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
    // A gap voltage that drifts is no motion.
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
