// Steps by series against rkf78, from a contact's beginning to its end.
#include "rubsweep/core/integrate/adaptive/series_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "core/integrate/curved_machine.hpp"
#include "rubsweep/core/integrate/adaptive/step_method.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"

namespace rubsweep::integrate::adaptive {
namespace {

using namespace test_curved;

/// A rotor and a casing 1 mm away that have just begun to touch.
struct Touching {
  explicit Touching(double exponent)
      : Touching(exponent, contact::FlatWall{{0, 1}}, model::StribeckFriction{{0, 0, 0, 0.2, 0.1, 0}}, 12) {
    begin({0.1, 1, 0, 0, 0.2, 0.8, 0, 0}, contact::Slip::forward);
  }

  Touching(double exponent, const contact::Wall& wall, const model::Friction& friction,
           double surface_m_per_s = 0)
      : scene(made(exponent, wall, friction, surface_m_per_s)), system(run::scale<4>(scene)), law(system, 0) {
    law.follow(pulses);
    law.modes()[0] = contact::Mode::sprung;
    law.begin_impact(0, 0.8);
    for (State* state : {&step.start, &step.start_rate, &step.end, &step.end_rate}) state->resize(8);
    step.start_phase = 0.5;
    step.latest_phase = 2 * std::numbers::pi;
  }

  void begin(const State& state, contact::Slip slip) {
    step.start = state;
    law.slips()[0] = slip;
    law(step.start, step.start_rate, step.start_phase);
  }

  static scene::Scene made(double exponent, const contact::Wall& wall, const model::Friction& friction,
                           double surface_m_per_s) {
    scene::Contact contact;
    contact.wall = wall;
    contact.casing_point = 1;
    contact.clearance_m = 1e-3;
    contact.surface_speed_m_per_s = surface_m_per_s;
    contact.friction = friction;
    const double stiffness = 1e6 / std::pow(5e-5, exponent - 1);
    give_law(power_stop(stiffness, exponent, ImpactDamping::hunt_crossley, 0.7), contact);
    return rotor_and_casing({contact}, 40);
  }

  scene::Scene scene;
  run::ScaledSystem<4> system;
  run::PulseTimes pulses{scene, system.scale, 2 * std::numbers::pi};
  law::Dynamics<4, false> law;
  Step step;
};

/// Follows a contact by series until an event ends a step, and by rkf78 beside them.
void follow(Touching& at, const char* name) {
  LawOfSteps<law::Dynamics<4, false>> law(at.law);
  const run::SolverOptions tight{.stepper = run::Stepper::rkf78, .relative_tolerance = 1e-13};
  const auto series = std::make_unique<SeriesStep<4>>(at.law, tight);
  const auto other = make_step_method(tight);
  Step small = at.step;
  double size = 1, small_size = 1e-5;
  State inside(8);
  for (int steps = 0; !at.step.ending; ++steps) {
    ASSERT_LT(steps, 40) << name;
    ASSERT_TRUE(series->try_step(law, at.step, size)) << name;
    ASSERT_TRUE(at.step.knows_modes) << name << " " << steps;
    for (const double share : {0.5, 1.0}) {
      const double phase = at.step.start_phase + share * (at.step.end_phase - at.step.start_phase);
      while (small.start_phase < phase) {
        double next = std::min(small_size, phase - small.start_phase);
        const bool last = next < small_size;
        const bool made = other->try_step(law, small, next);
        if (!made || !last) small_size = std::min(next, 1e-3);
        if (!made) continue;
        std::swap(small.start, small.end);
        std::swap(small.start_rate, small.end_rate);
        small.start_phase = last ? phase : small.end_phase;
      }
      series->state_at(law, at.step, phase, inside);
      EXPECT_LT(distance(inside, small.start), 1e-10) << name << " " << steps;
    }
    at.step.start = at.step.end, at.step.start_rate = at.step.end_rate;
    at.step.start_phase = at.step.end_phase;
  }
}

TEST(SeriesStep, FollowsAContactToItsEnd) {
  for (const double exponent : {1.0, 1.5, 2.0, 2.5}) {
    Touching at(exponent);
    follow(at, std::to_string(exponent).c_str());
    ASSERT_TRUE(at.step.ending);
    EXPECT_EQ(at.step.ending->next, contact::Mode::open);
    EXPECT_NEAR(at.step.end[1] - at.step.end[3], 1, 1e-13);
  }
}

/// Friction that holds the contact begins well inside the wall. The drive overcomes it before the contact
/// opens, with every exponent.
TEST(SeriesStep, FollowsAStickingContactToItsRelease) {
  for (const contact::Wall& wall :
       {contact::Wall(contact::FlatWall{{0, 1}}), contact::Wall(contact::AnnularWall{})}) {
    for (const double exponent : {1.0, 1.2, 1.5, 2.0, 2.6}) {
      Touching at(exponent, wall, model::ConstantFriction{0.3});
      const std::string name = (contact::annular(wall) ? "annular " : "flat ") + std::to_string(exponent);
      // The rotor moves along the normal alone.
      const Eigen::Vector2d place(contact::annular(wall) ? 0.1 : 0, 1.06), speed = 0.1 * place;
      at.begin({place.x(), place.y(), 0, 0, speed.x(), speed.y(), 0, 0}, contact::Slip::sticking);
      follow(at, name.c_str());
      ASSERT_TRUE(at.step.ending) << name;
      EXPECT_EQ(at.step.ending->event, Crossing::Event::release) << name;
      EXPECT_NEAR(at.law.slip(0, at.step.end), 0, 1e-12) << name;
      State rate(8);
      at.law.loose(at.step.end, rate, at.step.end_phase);
      const double holds_n = at.law.hold(at.step.end, rate).force_n(0);
      EXPECT_NEAR(
          contact::sign_of(at.step.ending->slip) * holds_n / at.law.largest_friction_n(0, at.step.end), 1,
          1e-9)
          << name;
    }
  }
}

/// First step after a touching, and tangent vectors that begin as the unit matrix.
struct FirstStep {
  explicit FirstStep(double exponent) : at(exponent) {
    LawOfSteps<law::Dynamics<4, false>> law(at.law);
    double size = 1e-3;
    EXPECT_TRUE(series->try_step(law, at.step, size));
  }

  bool move_vectors(double end_phase, double accuracy) {
    Eigen::Map<Eigen::MatrixXd> map(vectors.data(), 8, 8);
    return series->move_tangents(at.step, end_phase, {}, accuracy, map);
  }

  Touching at;
  std::unique_ptr<SeriesStep<4>> series = std::make_unique<SeriesStep<4>>(at.law, run::SolverOptions{});
  Eigen::MatrixXd vectors = Eigen::MatrixXd::Identity(8, 8);
};

TEST(SeriesStep, LeavesOtherLawsToTheStepper) {
  FirstStep first(1.3);
  EXPECT_FALSE(first.at.step.knows_modes);
  EXPECT_FALSE(first.move_vectors(first.at.step.end_phase, 1e-8));
  EXPECT_TRUE(first.vectors.isIdentity(0));
}

TEST(SeriesStep, MovesTangentVectorsOverItsSteps) {
  FirstStep first(1.5);
  const Step& step = first.at.step;
  ASSERT_TRUE(step.knows_modes);
  ASSERT_TRUE(first.move_vectors(step.start_phase, 1e-8));
  EXPECT_TRUE(first.vectors.isIdentity(0));
  // Displacements grow by the rates.
  const double end_phase = step.start_phase + 1e-3 * (step.end_phase - step.start_phase);
  ASSERT_TRUE(first.move_vectors(end_phase, 1e-8));
  EXPECT_NEAR(first.vectors(0, 4) / (end_phase - step.start_phase), 1, 1e-3);
}

/// To ten times the accuracy of the motion itself: over the whole step the series of the vectors end too
/// soon.
TEST(SeriesStep, HalvesAStepThatIsTooLongForTangentVectors) {
  FirstStep finely(1.5), coarsely(1.5);
  ASSERT_TRUE(finely.move_vectors(finely.at.step.end_phase, 1e-12));
  ASSERT_TRUE(coarsely.move_vectors(coarsely.at.step.end_phase, 1e-8));
  EXPECT_LT((finely.vectors - coarsely.vectors).norm(), 1e-6);
}

}  // namespace
}  // namespace rubsweep::integrate::adaptive
