// Machines for which solvers or proofs were wrong once; found by random search, see studies/audit.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "audit/dry_audit.hpp"
#include "audit/event_audit.hpp"
#include "audit/proof_audit.hpp"
#include "audit/wall_start.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/proof/orbit_ball.hpp"
#include "rubsweep/core/response/proof/periodic_orbit.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep {
namespace {

config::RunConfig read(const std::string& name) {
  return config::read_run_config(std::string(RUBSWEEP_TEST_DATA) + "/machines/" + name + ".yaml", {});
}

sweep::Row row_of(const std::string& name, double speed_hz, double whirl_ratio,
                  const integrate::run::SolverOptions& solver = {}) {
  sweep::Study study = read(name).study;
  study.grid = {{speed_hz}, sweep::UnbalanceMeasure::whirl_ratio, {whirl_ratio}};
  study.solver = solver;
  response::motion::Workspace workspace;
  return sweep::evaluate_cell(study, 0, workspace);
}

std::string label(const sweep::Row& row) {
  return fmt::format("{}{}{}", to_string(row.motion_class), row.order ? fmt::format(" {}", *row.order) : "",
                     row.proof ? fmt::format(" {}", to_string(*row.proof)) : "");
}

struct EventCell {
  const char* machine;
  double speed_hz, whirl_ratio;
  int turns;
};

class HardMachinesEvents : public testing::TestWithParam<EventCell> {};

/// Two contacts change their modes almost together: the first change must be handled first.
TEST_P(HardMachinesEvents, NoneIsPassedOverOrLate) {
  const auto [machine, speed_hz, whirl_ratio, turns] = GetParam();
  const auto audit = audit::audit_events({read(machine).study.machine, speed_hz, whirl_ratio}, turns);
  EXPECT_GE(audit.touched, 5);
  EXPECT_EQ(audit.exact_turns, audit.turns);
  ASSERT_FALSE(audit.difference) << audit.difference->turn << ' ' << audit.difference->exact_error << ' '
                                 << audit.difference->first_switch;
}

INSTANTIATE_TEST_SUITE_P(Of, HardMachinesEvents,
                         testing::Values(EventCell{"four_stops", 138.50961428204522, 0.8830485153668182, 60},
                                         EventCell{"three_stops", 30.490615403801954, 0.6338227589241093, 60},
                                         EventCell{"two_stops", 55.65629421162545, 0.46841560218741296, 120}),
                         [](const auto& cell) { return std::string(cell.param.machine); });

struct ProofCell {
  const char* machine;
  double speed_hz, whirl_ratio;
  const char* not_this;  ///< claim that was wrongly called proven
};

class HardMachinesProofs : public testing::TestWithParam<ProofCell> {};

/// Rotation alone can halve the maximum norm of a slowly decaying focus.
TEST_P(HardMachinesProofs, NameOnlyWhatTheRunComesTo) {
  const auto& [machine, speed_hz, whirl_ratio, not_this] = GetParam();
  const std::string found = label(row_of(machine, speed_hz, whirl_ratio));
  EXPECT_NE(found, not_this);
  if (!found.ends_with("floquet")) return;
  const auto audit = audit::audit_proof({read(machine).study.machine, speed_hz, whirl_ratio});
  EXPECT_TRUE(!audit.followed || audit.confirmed) << audit.finding;
}

INSTANTIATE_TEST_SUITE_P(
    Of, HardMachinesProofs,
    testing::Values(ProofCell{"focus_a", 142.567366660783, 0.5360785, "subharmonic 3 floquet"},
                    ProofCell{"focus_b", 108.01805551670208, 0.6724440334324026, "subharmonic 3 floquet"},
                    ProofCell{"focus_b", 112.66803696989342, 0.8502851858416605, "subharmonic 3 floquet"},
                    ProofCell{"focus_c", 217.33829715146, 0.5026265333926665, "subharmonic 3 floquet"},
                    ProofCell{"focus_d", 145.58822432879052, 0.625153635275109, "subharmonic 2 floquet"},
                    ProofCell{"focus_d", 167.06392968844887, 0.3375768176375545, "subharmonic 2 floquet"}));

TEST(HardMachines, AWhipHasTheSmallestPeriodOfTheRotatingFrame) {
  for (const double whirl_ratio : {0.1, 0.5034363264726616}) {
    const sweep::Row row = row_of("rolling", 65.47606509297073, whirl_ratio);
    EXPECT_EQ(label(row), "quasi_periodic floquet_observed");
    EXPECT_NEAR(row.measures.value().comb_spacing.value(), 6.6131, 1e-4);
    EXPECT_NEAR(row.floquet_modulus.value(), 0.99414, 1e-5);
  }
}

TEST(HardMachines, ATurnOfTooManyStepsIsMadeOfTaylorPieces) {
  const auto cell = scene::build_cell(read("stiff_friction").study.machine, 75, scene::WhirlRatio{0.4});
  integrate::exact::modes::ModeCache modes;
  const auto run = integrate::start(cell.scene, {}, modes);
  integrate::run::TurnReport turn;
  for (int k = 0; k < 4; ++k) ASSERT_EQ(run.advance({}, turn), integrate::run::Outcome::ok) << k;
  EXPECT_GT(turn.effort.taylor_turns, 0);
}

TEST(HardMachines, OneWayFrictionThatReversesSaysSoAndDryFrictionDoesNot) {
  sweep::Study study = read("slow_shaft").study;
  study.grid = {{0.3}, sweep::UnbalanceMeasure::whirl_ratio, {0.4}};
  response::motion::Workspace workspace;
  for (const auto method : {integrate::run::Method::automatic, integrate::run::Method::adaptive}) {
    study.solver.method = method;
    study.machine.stops[0].friction = model::OneWayFriction{0.1};
    EXPECT_EQ(sweep::evaluate_cell(study, 0, workspace).status, "slip_reversal");
    study.machine.stops[0].friction = model::ConstantFriction{0.1};
    EXPECT_EQ(sweep::evaluate_cell(study, 0, workspace).status, "ok");
  }
}

/// Damping constants of 1e-12 N s/m and less give the same labels as no damping.
TEST(HardMachines, DampingBelowRoundingIsNone) {
  for (const double damping : {1e-12, 1e-14, 1e-18}) {
    for (const auto method : {integrate::run::Method::exact, integrate::run::Method::adaptive}) {
      sweep::Study study = read("slow_shaft").study;
      study.machine.stops[0].friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}};
      study.machine.stops[0].damping = model::ExplicitDamping{damping};
      study.grid = {{70}, sweep::UnbalanceMeasure::whirl_ratio, {0.3, 0.8}};
      study.solver.method = method;
      response::motion::Workspace workspace;
      SCOPED_TRACE(damping);
      EXPECT_EQ(sweep::evaluate_cell(study, 0, workspace).order, 2);
      EXPECT_EQ(sweep::evaluate_cell(study, 1, workspace).order, 6);
    }
  }
}

/// Tests a few cells of every kind; `ctest -L audit` tests thousands.
TEST(HardMachines, AnAuditOfEventsInShort) {
  for (std::size_t i = 0; i < 60; ++i) {
    std::mt19937_64 random(9'000'000 + i);
    const auto kind = audit::stop_kinds[i % 3];
    const auto found = audit::audit_events(audit::random_cell(kind, random), 30);
    EXPECT_FALSE(found.difference) << i;
  }
}

/// Compares several simultaneous dry contacts with time stepping, which shares no code with the solvers.
TEST(HardMachines, AnAuditOfDryContactsInShort) {
  long stuck = 0;
  for (std::size_t i = 0; i < 48; ++i) {
    std::mt19937_64 random(7'000'000 + i);
    const auto kind = std::array{audit::StopKind::parallel_flats, audit::StopKind::ring_and_flats,
                                 audit::StopKind::rings}[i % 3];
    const auto found = audit::audit_dry_contacts(audit::random_cell(kind, random), 12);
    EXPECT_FALSE(found.difference) << i;
    EXPECT_FALSE(found.exact_failed) << i;
    stuck += found.stuck;
  }
  EXPECT_GT(stuck, 8);
}

/// Rotors that begin at a wall without radial speed: the first nonzero derivative decides.
TEST(HardMachines, AnAuditOfStartsOnWallsInShort) {
  int decided = 0;
  for (std::size_t i = 0; i < 90; ++i) {
    const audit::WallStart start = audit::random_wall_start(1, i);
    const audit::WallStartAudit found = audit::audit_wall_start(start);
    decided += found.decides;
    EXPECT_FALSE(found.decides && found.wrong) << i << ": " << start.description;
  }
  EXPECT_GT(decided, 80);
}

TEST(HardMachines, AnAuditOfProofsInShort) {
  int proven = 0;
  for (std::size_t i = 0; i < 120; ++i) {
    std::mt19937_64 random(8'000'000 + i);
    const auto kind = i % 4 == 0 ? audit::StopKind::equal_flats : audit::StopKind::one_flat;
    const auto found = audit::audit_proof(audit::random_cell(kind, random));
    proven += found.proof == response::motion::Proof::floquet;
    EXPECT_TRUE(!found.followed || found.confirmed || found.undecided) << i << ' ' << found.finding;
  }
  EXPECT_GT(proven, 20);
}

/// A random machine's orbit with its ball, if the run reaches one.
struct Ball {
  scene::Scene scene;
  integrate::exact::modes::ModeCache modes;
  response::proof::StableOrbit orbit;
  response::proof::AdaptedNorms norms;
  double radius = 0;

  response::proof::TurnMap turn(response::proof::SceneMap& map) const {
    return [&map](std::span<double> s, Eigen::MatrixXd* disturbances) {
      return disturbances ? map.carry(s, *disturbances) : map(s);
    };
  }

  bool find(const audit::RandomCell& random) {
    const auto cell =
        scene::build_cell(random.machine, random.speed_hz, scene::WhirlRatio{random.whirl_ratio});
    if (cell.start != scene::Start::quiet) return false;
    scene = response::proof::after_the_kick(cell.scene);
    const auto run = integrate::start(cell.scene, {}, modes);
    integrate::run::TurnReport made;
    for (int k = 0; k < 800; ++k) {
      if (run.advance({}, made) != integrate::run::Outcome::ok ||
          (k == 20 && made.effort.taylor_turns + made.effort.adaptive_turns > 0))
        return false;
    }
    if (!made.touched) return false;
    response::proof::SceneMap map(scene, {}, modes);
    for (int order = 1; order <= 6; ++order) {
      const auto found = response::proof::find_orbit(turn(map), made.section, order);
      if (!found) continue;
      const auto adapted = response::proof::adapted_norms(found->transitions);
      if (!adapted) return false;
      orbit = *found;
      norms = *adapted;
      const auto& x = orbit.sections[0];
      radius = response::proof::ball_radius(scene, modes, {x.begin(), x.end()}, norms).value_or(0);
      return radius > 0;
    }
    return false;
  }

  std::vector<std::pair<int, contact::Mode>> changes_from(std::vector<double>& section) {
    const auto run = integrate::start(scene, {}, modes);
    run.restart(section);
    integrate::run::TurnRequest asked;
    integrate::run::TurnReport made;
    asked.switches = true;
    EXPECT_EQ(run.advance(asked, made), integrate::run::Outcome::ok);
    section = made.section;
    std::vector<std::pair<int, contact::Mode>> changes;
    for (const auto& at : made.switches) changes.emplace_back(at.contact, at.to);
    return changes;
  }
};

/// From the boundary of each ball every turn has the orbit's own modes and comes closer to the orbit.
TEST(HardMachines, MotionsOnTheRimOfABallComeNearerByTheOrbitsOwnModes) {
  int balls = 0;
  for (std::size_t i = 0; i < 120 && balls < 12; ++i) {
    std::mt19937_64 random(7'000'000 + i);
    Ball ball;
    if (!ball.find(audit::random_cell(audit::stop_kinds[i % 2 == 0 ? 0 : 2], random))) continue;
    ++balls;
    SCOPED_TRACE(fmt::format("{} radius {} order {}", i, ball.radius, ball.orbit.order));
    const auto turns = ball.orbit.sections.size();
    std::normal_distribution<double> normal;
    for (std::size_t k = 0; k < turns; ++k) {
      const Eigen::VectorXd& centre = ball.orbit.sections[k];
      std::vector<double> own(centre.begin(), centre.end());
      const auto changes = ball.changes_from(own);
      for (int trial = 0; trial < 6; ++trial) {
        Eigen::VectorXd y(centre.size());
        for (double& x : y) x = normal(random);
        const Eigen::VectorXd from =
            centre + ball.norms.norm[k].triangularView<Eigen::Upper>().solve(ball.radius * y.normalized());
        std::vector<double> section(from.begin(), from.end());
        EXPECT_EQ(ball.changes_from(section), changes);
        const std::size_t next = (k + 1) % turns;
        const Eigen::Map<const Eigen::VectorXd> to(section.data(), centre.size());
        EXPECT_LT((ball.norms.norm[next] * (to - ball.orbit.sections[next])).norm(), ball.radius);
      }
    }
  }
  EXPECT_EQ(balls, 12);
}

}  // namespace
}  // namespace rubsweep
