#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "rubsweep/core/integrate/start.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact {

/// A turn with contact, well after the kick; by default of parameter set A.
struct RubbingTurn {
  scene::Scene scene;
  modes::ModeCache modes;
  std::vector<double> start, end;
  Eigen::MatrixXd transition;

  explicit RubbingTurn(scene::Scene given = test::cell_of({}).scene) : scene(std::move(given)) {
    const run::Run kicked = integrate::start(scene, {}, modes);
    run::TurnReport turn;
    do {
      EXPECT_EQ(kicked.advance({}, turn), run::Outcome::ok);
      start = turn.section;
      scene.pulses.clear();
      turn_from(start, turn);
    } while (turn.effort.steps < 10'000 && (!turn.touched || turn.touching_at_end));
    EXPECT_TRUE(turn.touched);
    end = turn.section;
    transition = *turn.tangent_vectors.get();
  }

  void turn_from(const std::vector<double>& section, run::TurnReport& turn) {
    const auto run = integrate::start(scene, {}, modes);
    const auto states = static_cast<Eigen::Index>(section.size());
    run::TurnRequest asked;
    asked.tangent_vectors = Eigen::MatrixXd::Identity(states, states);
    run.restart(section);
    EXPECT_EQ(run.advance(asked, turn), run::Outcome::ok);
  }
};

}  // namespace rubsweep::integrate::exact
