#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rubsweep/core/numerics/modal_form_cache.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::response::proof {

/// Proves that a rotor without contact will never touch again. Free vibration about the quiet motion is a sum
/// of pairs of modal coordinates whose lengths a_j cannot grow (integrate::ModalForm). With row r of a
/// contact (p = r q - clearance) therefore
/// p(t) <= static part + harmonic amplitude + sum_j |r basis_j| a_j for all later t.
/// If this bound is below zero for every contact, no contact can occur. In an annular stop |r basis_j| is the
/// largest displacement of the rotor by pair j.
class RestProof {
 public:
  /// Never proves anything (`proves` is always false) when the quiet motion itself touches, a mode grows,
  /// there is no modal form, or impulses continue to disturb the rotor. `forms`: cache of modal forms that
  /// cells of one speed share.
  RestProof(const scene::Cell& cell, numerics::ModalFormCache& forms);
  explicit RestProof(const scene::Cell& cell);

  /// Whether some free vibration of the rotor without its stops grows, so that no quiet motion lasts. Known
  /// for every start of the run.
  bool vibration_grows() const { return grows_; }

  /// Whether there will be no contact after `section`, a scaled state as TurnReport::section at the start of
  /// a revolution with every contact open and the kick over.
  bool proves(std::span<const double> section);

 private:
  struct Bound {
    double quiet_penetration = 0;  ///< static part + harmonic amplitude, in units of the length scale
    Eigen::VectorXd pair_weight;   ///< |r basis_j| of each pair j
  };

  bool usable_ = false, grows_ = false;
  Eigen::MatrixXd to_modes_;
  Eigen::VectorXd quiet_;  ///< scaled state of the quiet motion at phase 0
  std::vector<Bound> bounds_;
  Eigen::VectorXd vibration_, modes_, lengths_;  ///< buffers for the latest section
};

}  // namespace rubsweep::response::proof
