#include "rubsweep/response/proof/orbit_ball.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "rubsweep/integrate/exact/exact_tube.hpp"

namespace rubsweep::response::proof {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double largest_radius = 0.1, smallest_radius = 1e-9;
/// What a turn's own deviation may take of what the linear map leaves to 1, and how far the sections given
/// may be from the orbit itself against the radius: the 5 % that the shares leave cover what that changes.
constexpr double deviation_share = 0.9, defect_share = 1e-3;

}  // namespace

std::optional<double> ball_radius(const scene::Scene& scene, integrate::exact::ModeCache& modes,
                                  const std::vector<double>& section, const AdaptedNorms& norms) {
  std::vector<double> now = section;
  std::vector<integrate::exact::TurnTube> tubes;
  const std::size_t turns = norms.norm.size();
  for (std::size_t i = 0; i < turns; ++i) {
    const MatrixXd& norm = norms.norm[i];
    const MatrixXd unit =
        norm.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(norm.rows(), norm.cols()));
    auto tube = integrate::exact::turn_tube(scene, modes, now, unit, norms.norm[(i + 1) % turns]);
    if (!tube) return std::nullopt;
    tubes.push_back(std::move(*tube));
  }
  const auto as_vector = [](const std::vector<double>& x) {
    return Eigen::Map<const VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  };
  const double defect = (norms.norm.front() * (as_vector(now) - as_vector(section))).norm();
  double contraction = 0;
  for (const integrate::exact::TurnTube& tube : tubes) contraction = std::max(contraction, tube.contraction);
  // Not as the norms were made, but as the tubes' own linear maps are.
  const double room = 1 - contraction;
  if (!(room > 0)) return std::nullopt;
  for (double radius = largest_radius; radius >= smallest_radius; radius /= 2) {
    if (!(defect <= defect_share * 0.1 * room * radius)) return std::nullopt;
    const bool holds = std::ranges::all_of(tubes, [&](const integrate::exact::TurnTube& tube) {
      return tube.deviation(radius) <= deviation_share * room * radius;
    });
    if (holds) return radius;
  }
  return std::nullopt;
}

}  // namespace rubsweep::response::proof
