#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/exact/tube/turn_tube.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::proof {

/// Norms on the sections of an orbit as AdaptedNorms, but separate for two parts of a disturbance: the *slow*
/// part, which no contact sees, is a free vibration along flat walls that only the structure's own damping
/// takes away, the *fast* one all the rest.
struct SplitNorms {
  /// Per turn, on a section: the first `fast` rows give the fast part in its norm, the others the slow one.
  std::vector<Eigen::MatrixXd> norm;
  std::vector<Eigen::MatrixXd> unit;  ///< their inverses
  Eigen::Index fast = 0;
  /// Contraction of either part by every turn, < 1; besides, the fast part drives the slow one.
  integrate::exact::tube::Parts contraction;

  Eigen::Index slow() const { return norm.front().rows() - fast; }
};

/// The rows on a section by which the contacts of a scene see it: penetrations, then their rates.
Eigen::MatrixXd seen_by_contacts(const scene::Scene& scene);

/// Norms for the turns `transitions` of an orbit, see adapted_norms. `seen` is seen_by_contacts. A multiplier
/// belongs to the slow part where its eigenvectors are zero in all of these, to rounding, and where it loses
/// less than half in a turn. Each part has the adapted norm of what the orbit's turns make of it: of the slow
/// part, which the turns keep to itself, and of sections up to it. Empty where there is no slow part, no
/// other, or no norm.
std::optional<SplitNorms> split_norms(const std::vector<Eigen::MatrixXd>& transitions,
                                      const Eigen::MatrixXd& seen);

/// Lengths of the two parts of `offset` from section `turn` of the orbit.
integrate::exact::tube::Parts parts_of(const SplitNorms& norms, std::size_t turn,
                                       const Eigen::VectorXd& offset);

}  // namespace rubsweep::response::proof
