#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::motion {

/// The last two windows of a run, filled turn by turn.
class Record {
 public:
  Record(const scene::Scene& scene, const ResponseOptions& options);

  /// Forgets what was recorded; `section` is that at the start of the first turn that will be.
  void begin(std::span<const double> section);

  /// A turn with `samples_per_revolution` samples and peaks; two windows of them fill the record.
  void add(const integrate::run::TurnReport& turn);

  /// 0: the older window, 1: the newer.
  Window window(std::size_t which) const;

  /// Samples of the observed point over both windows, in metres.
  std::span<const std::complex<double>> displacement_m() const { return displacement_m_; }

 private:
  ResponseOptions options_;
  Eigen::Matrix<double, 2, Eigen::Dynamic> map_;  ///< scaled displacements to (x, y) in metres
  double length_scale_m_;
  std::size_t states_;
  std::vector<std::complex<double>> displacement_m_;
  std::vector<double> section_;
  std::vector<ContactFacts> facts_;
};

}  // namespace rubsweep::response::motion
