// Tangent vectors at contacts with nonlinear laws. They are compared with differences of the equations in
// long double, and, for a nonlinear law with the exponent 1, with the exact solver.
#include "rubsweep/core/integrate/adaptive/step_tangents.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/integrate/curved_machine.hpp"
#include "rubsweep/core/integrate/start.hpp"

namespace rubsweep::integrate::adaptive {
namespace {

using namespace test_curved;

run::SolverOptions tight() { return {.relative_tolerance = 1e-12}; }

/// Largest difference between the tangent vectors of the exact solver and those of the same contacts by a
/// curved law with the exponent 1, divided by the norm of the exact ones. Each of the `turns` turns begins at
/// the section of the exact solver.
double difference_from_exact(const std::vector<scene::Contact>& contacts, double force_n, int turns,
                             int& hits, int& stuck) {
  std::vector<scene::Contact> curved = contacts;
  for (scene::Contact& contact : curved) give_law(power_stop(contact.stiffness_n_per_m, 1), contact);
  exact::modes::ModeCache modes;
  const run::Run exact = start(rotor_and_casing(contacts, force_n), {}, modes),
                 steps = start(rotor_and_casing(curved, force_n), tight(), modes);
  run::TurnRequest asked;
  asked.tangent_vectors.setIdentity(8, 8);
  run::TurnReport a, b;
  double largest = 0;
  std::vector<double> from;
  for (int k = 0; k < turns; ++k) {
    if (!from.empty()) exact.restart(from), steps.restart(from);
    EXPECT_EQ(exact.advance(asked, a), run::Outcome::ok);
    EXPECT_EQ(steps.advance(asked, b), run::Outcome::ok);
    if (!a.tangent_vectors.get() || !b.tangent_vectors.get()) return 1e9;
    const Eigen::MatrixXd& expected = *a.tangent_vectors.get();
    largest =
        std::max(largest, (*b.tangent_vectors.get() - expected).cwiseAbs().maxCoeff() / expected.norm());
    hits += a.hits;
    stuck += std::abs(expected.determinant()) < 1e-9;  // the matrix loses a rank where a contact sticks
    from = a.section;
  }
  return largest;
}

scene::Contact linear_contact(const contact::Wall& wall, const model::Friction& friction,
                              double surface_m_per_s) {
  scene::Contact contact;
  contact.wall = wall;
  contact.casing_point = 1;
  contact.clearance_m = 1e-3;
  contact.stiffness_n_per_m = 2e6;
  contact.friction = friction;
  contact.surface_speed_m_per_s = surface_m_per_s;
  return contact;
}

TEST(StepTangents, ExponentOneHasThoseOfTheExactSolver) {
  for (const contact::Wall& wall :
       {contact::Wall(contact::FlatWall{{0, 1}}), contact::Wall(contact::AnnularWall{})}) {
    int hits = 0, stuck = 0;
    EXPECT_LT(
        difference_from_exact({linear_contact(wall, model::ConstantFriction{0.1}, 8)}, 40, 3, hits, stuck),
        1e-8);
    EXPECT_GT(hits, 0);
    EXPECT_EQ(stuck, 0);
  }
}

/// Contacts that stick and let go. At these instants the rate of the state jumps.
TEST(StepTangents, CrossTheJumpsOfDryFriction) {
  const model::Friction frictions[] = {model::ConstantFriction{0.4}, model::StaticFriction{0.5, 0.3}};
  for (const model::Friction& friction : frictions) {
    int hits = 0, stuck = 0;
    for (const double surface : {0.0, 0.05})
      EXPECT_LT(difference_from_exact({linear_contact(contact::FlatWall{{0, 1}}, friction, surface)}, 40, 6,
                                      hits, stuck),
                1e-7)
          << friction.index() << " " << surface;
    EXPECT_GT(hits, 3);
    EXPECT_GT(stuck, 3);
  }
}

/// Two contacts and three directions. No vector depends on the others, and the motion does not depend on the
/// vectors.
TEST(StepTangents, WatchingDoesNotMoveTheRotor) {
  scene::Contact wall = linear_contact(contact::FlatWall{{0, 1}}, model::ConstantFriction{0.1}, 8);
  scene::Contact ring = linear_contact(contact::AnnularWall{}, model::ConstantFriction{0.2}, 8);
  give_law(power_stop(3e7, 1.5, ImpactDamping::delivered, 0.6), wall);
  give_law(power_stop(3e8, 2, ImpactDamping::hunt_crossley, 0.8), ring);
  ring.clearance_m = 1.1e-3;
  const scene::Scene scene = rotor_and_casing({wall, ring}, 40);
  exact::modes::ModeCache modes;
  const run::Run plain = start(scene, {}, modes), watched = start(scene, {}, modes);
  run::TurnRequest asked;
  asked.tangent_vectors.setIdentity(8, 3);
  run::TurnReport a, b;
  int moved = 0;
  bool began_touching = false;
  for (int k = 0; k < 20; ++k) {
    ASSERT_EQ(plain.advance({}, a), run::Outcome::ok);
    ASSERT_EQ(watched.advance(asked, b), run::Outcome::ok);
    EXPECT_EQ(a.section, b.section);
    EXPECT_EQ(a.tangent_vectors.get(), nullptr);
    // A section in contact does not show how the contact began. No vectors are returned then, since they
    // would be wrong.
    if (began_touching) {
      EXPECT_EQ(b.tangent_vectors.get(), nullptr);
    }
    began_touching = b.touching_at_end;
    moved += b.tangent_vectors.get() != nullptr;
  }
  EXPECT_GT(moved, 3);
}

/// A vector that continues from turn to turn includes the change of the damping, also if turns begin in
/// contact.
TEST(StepTangents, GoOnInAContactThatRemembersHowItBegan) {
  scene::Contact wall = linear_contact(contact::FlatWall{{0, 1}}, model::ConstantFriction{0.1}, 8);
  wall.clearance_m = 3e-4;
  give_law(power_stop(1e6, 1.5, ImpactDamping::hunt_crossley, 0.4), wall);
  int touching = 0;
  for (const double angle_deg : {0.0, 90.0, 180.0}) {
    wall.wall = contact::FlatWall{contact::direction(angle_deg)};
    const scene::Scene scene = rotor_and_casing({wall}, 60);
    exact::modes::ModeCache modes;
    const std::vector<double> from(8, 0.01);
    const Eigen::VectorXd way = Eigen::VectorXd::LinSpaced(8, -1, 1);
    constexpr int turns = 6;
    const auto end_of = [&](double by) {
      std::vector<double> section = from;
      for (std::size_t i = 0; i < 8; ++i) section[i] += by * way(Eigen::Index(i));
      const run::Run run = start(scene, tight(), modes);
      run.restart(section);
      run::TurnReport turn;
      for (int k = 0; k < turns; ++k) EXPECT_EQ(run.advance({}, turn), run::Outcome::ok);
      return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(turn.section.data(), 8));
    };
    const run::Run run = start(scene, tight(), modes);
    run.restart(from);
    run::TurnRequest asked;
    asked.tangent_vectors = way;
    run::TurnReport turn;
    double length = 1;
    for (int k = 0; k < turns; ++k) {
      ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
      ASSERT_NE(turn.tangent_vectors.get(), nullptr) << angle_deg << " " << k;
      const double norm = turn.tangent_vectors.get()->norm();
      asked.tangent_vectors = *turn.tangent_vectors.get() / norm;
      length *= norm;
      touching += turn.touching_at_end;
    }
    constexpr double by = 1e-6;
    const Eigen::VectorXd expected = (end_of(by) - end_of(-by)) / (2 * by);
    EXPECT_LT((length * asked.tangent_vectors - expected).norm(), 1e-4 * expected.norm()) << angle_deg;
  }
  EXPECT_GT(touching, 2);
}

/// A disturbance of the start changes the section at the end. Returns the largest difference between this
/// change and the tangent vector, relative to the change. Negative if at the end of the turn a contact
/// touches whose damping depends on its own impact.
double error_of_derivative(unsigned seed) {
  const RandomMachine machine(seed);
  exact::modes::ModeCache modes;
  const run::Run run = start(machine.scene, tight(), modes);
  run::TurnRequest asked;
  asked.tangent_vectors = Eigen::VectorXd::LinSpaced(8, -1, 1.3).cwiseAbs();
  run::TurnReport turn;
  EXPECT_EQ(run.advance(asked, turn), run::Outcome::ok);
  if (!turn.tangent_vectors.get() || turn.hits == 0) return -1;
  const auto end_of = [&](double by) {
    Reference reference = machine.reference();
    reference.longest = 2e-3L;
    for (std::size_t i = 0; i < 8; ++i)
      reference.state[i] += by * Real(asked.tangent_vectors(Eigen::Index(i), 0)) * 1e-3L *
                            (i < 4 ? 1 : Real(machine.scene.speed_rad_per_s));
    return reference.after_turns(1);
  };
  constexpr double by = 2e-6;
  const std::vector<double> ahead = end_of(by), behind = end_of(-by);
  const Eigen::VectorXd moved = turn.tangent_vectors.get()->col(0);
  double largest = 0;
  for (std::size_t i = 0; i < 8; ++i)
    largest = std::max(largest, std::abs((ahead[i] - behind[i]) / (2 * by) - moved(Eigen::Index(i))));
  return largest / moved.norm();
}

/// RUBSWEEP_CURVED_MACHINES=N for more of them.
TEST(StepTangents, AreTheDerivativesOfTheEquations) {
  const char* wanted = std::getenv("RUBSWEEP_CURVED_MACHINES");
  const unsigned machines = wanted != nullptr ? unsigned(std::atoi(wanted)) : 6;
  unsigned compared = 0;
  for (unsigned seed = 1; seed <= machines; ++seed) {
    const double error = error_of_derivative(seed);
    if (error < 0) continue;
    ++compared;
    EXPECT_LT(error, 1e-6) << seed;
  }
  EXPECT_GT(compared, machines / 3);
}

}  // namespace
}  // namespace rubsweep::integrate::adaptive
