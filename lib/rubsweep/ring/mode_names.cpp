#include "rubsweep/ring/mode_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rubsweep/numerics/assignment.hpp"

namespace rubsweep::ring {
namespace {

using Eigen::Index;

/// Pairs of eigenvalues that belong together: conjugates, and the real ones by size, two by two.
std::vector<std::pair<Index, Index>> natural_pairs(const Eigen::VectorXcd& values) {
  std::vector<std::pair<Index, Index>> pairs;
  std::vector<Index> real;
  for (Index i = 0; i < values.size(); ++i) {
    if (values(i).imag() == 0) real.push_back(i);
    if (values(i).imag() > 0) pairs.emplace_back(i, i + 1);  // Eigen lists conjugates one after the other
  }
  std::sort(real.begin(), real.end(),
            [&](Index a, Index b) { return std::abs(values(a)) < std::abs(values(b)); });
  for (std::size_t i = 0; i + 1 < real.size(); i += 2) pairs.emplace_back(real[i], real[i + 1]);
  return pairs;
}

}  // namespace

std::vector<std::string> mode_names(const System& system) {
  std::vector<std::string> names{"ring forward", "ring backward"};
  for (std::size_t j = 0; j < system.loads.size(); ++j) {
    if (system.loads[j].motion == Motion::radial) continue;
    const bool along = std::abs(system.loads[j].inclination_deg) > 45;
    names.push_back(fmt::format("load {} {}", j, along ? "radial" : "flexural"));
  }
  return names;
}

std::vector<int> first_modes(const Spectrum& spectrum) {
  const auto pairs = natural_pairs(spectrum.values);
  const Index modes = static_cast<Index>(pairs.size());
  // Share of every pair's motion in the coordinates of the loads; the ring takes what is left.
  Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(modes, modes);
  for (Index p = 0; p < modes; ++p) {
    const auto shape = spectrum.vectors.col(pairs[static_cast<std::size_t>(p)].first).head(modes);
    for (Index k = 2; k < modes; ++k) cost(p, k) = -std::norm(shape(k)) / shape.squaredNorm();
  }
  const auto taken = numerics::cheapest_assignment(cost);
  std::vector<Index> ring;
  std::vector<int> mode(static_cast<std::size_t>(2 * modes));
  const auto give = [&](Index pair, int name) {
    const auto [first, second] = pairs[static_cast<std::size_t>(pair)];
    mode[static_cast<std::size_t>(first)] = mode[static_cast<std::size_t>(second)] = name;
  };
  for (Index p = 0; p < modes; ++p) {
    const Index k = taken[static_cast<std::size_t>(p)];
    if (k < 2) {
      ring.push_back(p);
    } else {
      give(p, static_cast<int>(k));
    }
  }
  give(ring[0], 0);
  give(ring[1], 1);
  return mode;
}

std::string shape_name(const std::vector<std::string>& names, int nodal_diameters, double speed_rad_per_s,
                       std::complex<double> value, const Eigen::VectorXcd& vector) {
  const auto shape = vector.head(vector.size() / 2);
  Index load = 1;
  double most = 0;
  for (Index k = 2; k < shape.size(); ++k) {
    if (std::norm(shape(k)) > most) {
      most = std::norm(shape(k));
      load = k;
    }
  }
  if (most > shape.head<2>().squaredNorm()) return names[static_cast<std::size_t>(load)];
  if (value.imag() == 0) return "ring";
  // A cos n phi + B sin n phi runs towards +phi in the rotating frame when B lags behind A.
  const bool with_frame = (shape(0) * std::conj(shape(1))).imag() * value.imag() > 0;
  const double relative = (with_frame ? 1 : -1) * std::abs(value.imag()) / nodal_diameters;
  return names[speed_rad_per_s + relative > 0 ? 0 : 1];
}

void pair_up(const Eigen::VectorXcd& values, std::vector<int>& mode) {
  for (Index i = 0; i + 1 < values.size(); ++i) {
    if (!(values(i).imag() > 0)) continue;
    int& first = mode[static_cast<std::size_t>(i)];
    int& second = mode[static_cast<std::size_t>(i) + 1];
    if (first == second) continue;
    const int kept = first, given_away = second;
    second = kept;
    for (Index k = 0; k < values.size(); ++k) {
      int& other = mode[static_cast<std::size_t>(k)];
      if (k != i && k != i + 1 && other == kept) other = given_away;
    }
  }
}

}  // namespace rubsweep::ring
