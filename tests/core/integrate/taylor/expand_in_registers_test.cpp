#include "rubsweep/core/integrate/taylor/expand_in_registers.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "core/integrate/taylor/set_c_scene.hpp"
#include "core/integrate/taylor/turned_contact.hpp"
#include "rubsweep/core/integrate/taylor/expansion.hpp"
#include "rubsweep/core/integrate/taylor/tangent_expansion.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Mode;

const std::vector<double> start_state{1.3, 0.4, 0.1, -0.1, 0.5, -0.9, 0.2, 0.3};
constexpr double duration = 0.05;

/// Scenes with an annular and a flat stop, with constant and with varying friction.
std::vector<scene::Scene> scenes() {
  std::vector<scene::Scene> all{set_c_scene(80, 0.6), test::cell_of({}).scene};
  for (std::size_t i = 0; i < 2; ++i) {
    all.push_back(all[i]);
    all.back().contacts[0].surface_speed_m_per_s = 0.2;
    all.back().contacts[0].friction = model::StribeckFriction{{0, 0, 0, 0.1, 2, 0}};
  }
  for (scene::Scene& scene : all) scene.pulses.clear();
  return all;
}

/// State after one step, and the images of all tangent vectors.
struct Moved {
  std::vector<double> state = std::vector<double>(8);
  Eigen::MatrixXd tangents = Eigen::MatrixXd::Identity(8, 8);
  Eigen::MatrixXd alone = Eigen::VectorXd::Unit(8, 5);
  bool in_registers = false;
};

Moved step(const run::ScaledSystem<4>& system, const scene::Scene& scene, double accuracy,
           Mode mode = Mode::sprung) {
  Moved moved;
  Expansion<4> motion(system);
  const run::PulseTimes no_pulses(scene, run::state_scale(scene), 2 * std::numbers::pi);
  motion.expand(start_state.data(), 0.3, no_pulses, {mode}, {contact::Slip::forward});
  moved.in_registers = motion.only_slip().has_value() || motion.flies();
  motion.series().put_state(duration, moved.state.data());
  for (Eigen::MatrixXd* vectors : {&moved.tangents, &moved.alone}) {
    TangentExpansion<4> tangents(system);
    tangents.begin(*vectors);
    EXPECT_TRUE(tangents.pass(motion, duration, accuracy));
    *vectors = tangents.vectors();
  }
  return moved;
}

/// Compares with the general code for any structure, to which the same structure is given as full matrices.
void expect_agreement(const run::ScaledSystem<4>& system, const scene::Scene& scene,
                      Mode mode = Mode::sprung) {
  run::ScaledSystem<4> full = system;
  full.diagonal = false;
  const Moved here = step(system, scene, 1e-14, mode), there = step(full, scene, 1e-14, mode);
  EXPECT_TRUE(here.in_registers);
  EXPECT_FALSE(there.in_registers);
  EXPECT_LT(largest_difference(here.state, there.state), 1e-14);
  EXPECT_GT(largest_difference(here.state, start_state), 0.01);
  const double size = there.tangents.cwiseAbs().maxCoeff();
  EXPECT_LT((here.tangents - there.tangents).cwiseAbs().maxCoeff(), 1e-13 * size);
  // Several vectors share a Jacobian.
  EXPECT_LT((here.alone - here.tangents.col(5)).cwiseAbs().maxCoeff(), 1e-14 * size);
}

TEST(ExpandInRegisters, AgreesWithTheExpansionOfAnyStructure) {
  for (const scene::Scene& scene : scenes()) expect_agreement(run::scale<4>(scene), scene);
}

TEST(ExpandInRegisters, AgreesWhereTheContactIsAtAnAngleToTheCoordinates) {
  for (const scene::Scene& scene : scenes()) {
    auto system = run::scale<4>(scene);
    system.contacts[0] = turned(system.contacts[0], 0.4);
    expect_agreement(system, scene);
  }
}

TEST(ExpandInRegisters, AgreesWhereNothingTouches) {
  for (const scene::Scene& scene : scenes()) {
    const auto system = run::scale<4>(scene);
    expect_agreement(system, scene, Mode::open);
    EXPECT_GT(
        largest_difference(step(system, scene, 1e-14, Mode::open).state, step(system, scene, 1e-14).state),
        1e-5);
  }
}

/// Tangent vectors with a lower accuracy use only as many terms as they need.
TEST(ExpandInRegisters, ExpandsTangentsAsFarAsIsAskedFor) {
  for (const scene::Scene& scene : scenes()) {
    const auto system = run::scale<4>(scene);
    const Eigen::MatrixXd fine = step(system, scene, 1e-14).tangents,
                          rough = step(system, scene, 1e-3).tangents;
    const double error = (rough - fine).cwiseAbs().maxCoeff() / fine.cwiseAbs().maxCoeff();
    EXPECT_GT(error, 1e-12);
    EXPECT_LT(error, 1e-3);
  }
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
