#include "rubsweep/core/integrate/flight_run.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "rubsweep/core/integrate/adaptive/adaptive_run.hpp"
#include "rubsweep/core/integrate/adaptive/series_step.hpp"
#include "rubsweep/core/integrate/exact/exact_run.hpp"
#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/integrate/run/coordinates.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/numerics/flush_subnormals.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::integrate {
namespace {

/// Latest phase at which closed forms take over again; after it too little time is left in the turn.
constexpr double last_join = numerics::full_turn - 1e-9;

/// The scene with linear contacts in place of others; its flights are the same.
scene::Scene with_linear_contacts(scene::Scene scene) {
  for (scene::Contact& contact : scene.contacts) contact.law = nullptr;
  return scene;
}

template <int N>
class FlightRun {
 public:
  FlightRun(const scene::Scene& scene, const run::SolverOptions& options,
            std::shared_ptr<exact::modes::MachineModes<N>> modes)
      : flight_(with_linear_contacts(scene), std::move(modes), options.max_steps_per_revolution, true),
        contact_(scene, options),
        touches_(contact_.touches()),
        max_steps_(options.max_steps_per_revolution),
        max_evaluations_(run::most_evaluations_of_a_turn(options)) {
    contact_.step_by(std::make_unique<adaptive::SeriesStep<N>>(contact_.law(), options));
  }

  run::Outcome operator()(const run::TurnRequest& request, run::TurnReport& report) {
    const run::Effort before = effort();
    most_steps_ = before.steps + max_steps_;
    most_calls_ = before.rhs_calls + max_evaluations_;
    const run::Outcome outcome = make_turn(request, report);
    report.effort = effort();
    return outcome;
  }

  void restart(std::span<const double> section) {
    flies_ = true;
    flight_.restart(section);
    contact_.restart(section, 0);
    touches_ = contact_.touches();
  }

 private:
  run::Outcome make_turn(const run::TurnRequest& request, run::TurnReport& report) {
    if (touches_ || !flies_) return from_contact(request, report);
    flight_.put_section(section_);
    const run::Outcome outcome = flight_.advance(request, report);
    if (outcome == run::Outcome::ok) return outcome;
    if (outcome == run::Outcome::unsaturated && flight_.handover().phase_rad > 0) {
      touch(request, report);
      return go_on(request, report);
    }
    // A structure without closed forms, or a turn that begins within rounding of a wall.
    flies_ = outcome == run::Outcome::unsaturated;
    contact_.restart(section_, flight_.revolution());
    return from_contact(request, report);
  }

  /// Makes a turn whose beginning is the stepper's.
  run::Outcome from_contact(const run::TurnRequest& request, run::TurnReport& report) {
    flight_.begin_elsewhere(request, report);
    contact_.begin_turn(request);
    return go_on(request, report);
  }

  /// Hands over to the stepper at the touching that ended a flight.
  void touch(const run::TurnRequest& request, run::TurnReport& report) {
    const auto& place = flight_.handover();
    rest_ = request;
    rest_.tangent_vectors = place.tangent_vectors;
    contact_.join(rest_, flight_.revolution(), place.phase_rad, place.state, place.touches, report);
  }

  /// Contacts, flights and contacts until the turn is over.
  run::Outcome go_on(const run::TurnRequest& request, run::TurnReport& report) {
    for (;;) {
      if (effort().steps >= most_steps_ || effort().rhs_calls >= most_calls_) return run::Outcome::step_limit;
      const run::Outcome ending = contact_.go_on(request, report, flies_);
      if (ending != run::Outcome::ok) return ending;
      if (contact_.at_end_of_turn()) break;
      if (contact_.phase() > last_join ||
          !flight_.join(contact_.phase(), contact_.state(), contact_.modes(), report)) {
        const run::Outcome rest = contact_.go_on(request, report, false);
        if (rest != run::Outcome::ok) return rest;
        break;
      }
      contact_.put_tangents(vectors_);
      const run::Outcome flown = flight_.go_to_end(vectors_, report);
      if (flown == run::Outcome::ok) {
        touches_ = false;
        return flown;
      }
      if (flown != run::Outcome::unsaturated) return flown;
      touch(request, report);
    }
    const run::Outcome outcome = contact_.finish_turn(report);
    touches_ = report.touching_at_end;
    flight_.resume(report.section);
    return outcome;
  }

  run::Effort effort() const { return flight_.effort() + contact_.effort(); }

  exact::ExactRun<N> flight_;
  adaptive::AdaptiveRun<law::Dynamics<N, false>> contact_;
  bool touches_;                          ///< a contact touches at the start of the next turn
  bool flies_ = true;                     ///< closed forms of the flights exist
  long max_steps_, max_evaluations_;      ///< limits for a turn
  long most_steps_ = 0, most_calls_ = 0;  ///< efforts at which the present turn reaches its limits
  std::vector<double> section_;
  run::TurnRequest rest_;  ///< request with the tangent vectors at a touching
  Eigen::MatrixXd vectors_;
};

}  // namespace

bool may_fly(const scene::Scene& scene, const run::SolverOptions& options) {
  return options.method == run::Method::automatic && options.stepper == run::Stepper::automatic &&
         options.contact == run::ContactHandling::located && !scene.twist && scene.impulses.empty() &&
         std::ranges::any_of(scene.contacts, [](const auto& c) { return c.law != nullptr; }) &&
         exact::modes::exact_applies(with_linear_contacts(scene));
}

run::Run start_flights(const scene::Scene& scene, const run::SolverOptions& options,
                       exact::modes::ModeCache& modes) {
  return run::with_coordinates(scene.structure.coordinates(), [&](auto n) -> run::Run {
    auto run =
        std::make_shared<FlightRun<n()>>(scene, options, modes.modes_of<n()>(with_linear_contacts(scene)));
    return {[run](const run::TurnRequest& request, run::TurnReport& report) {
              const numerics::FlushSubnormals flush;
              return (*run)(request, report);
            },
            [run](std::span<const double> section) { run->restart(section); }};
  });
}

}  // namespace rubsweep::integrate
