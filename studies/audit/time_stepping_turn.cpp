#include "audit/time_stepping_turn.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"

namespace rubsweep::audit {
namespace {

constexpr Eigen::Index most_contacts = 4;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 16, 1>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 16, 16>;
using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_contacts, 1>;
using FewByFew =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_contacts, most_contacts>;

/// Friction of one step: the slips at its end are `start` - `mobility` f with |f| <= `limit`.
struct Friction {
  FewByFew mobility;
  Few start, limit, force;
  int stuck = 0, at_zero = 0;

  /// Largest violation of the friction law for `code`, whose ternary digits stand for the contacts: 0 slips
  /// backward, 1 sticks, 2 slips forward.
  double try_code(int code) {
    std::array<Eigen::Index, most_contacts> free{};
    Eigen::Index count = 0;
    const Eigen::Index n = start.size();
    for (Eigen::Index i = 0, rest = code; i < n; ++i, rest /= 3) {
      force(i) = static_cast<double>(rest % 3 - 1) * limit(i);
      if (rest % 3 == 1) free[static_cast<std::size_t>(count++)] = i;
    }
    if (count > 0) {
      Few wanted(count);
      FewByFew inner(count, count);
      for (Eigen::Index k = 0; k < count; ++k) {
        const Eigen::Index i = free[static_cast<std::size_t>(k)];
        wanted(k) = start(i) - mobility.row(i).dot(force);
        for (Eigen::Index l = 0; l < count; ++l) inner(k, l) = mobility(i, free[static_cast<std::size_t>(l)]);
      }
      Few found(count);
      if (count == 1)
        found(0) = wanted(0) / inner(0, 0);
      else
        found = numerics::dense::least_norm_solution(Eigen::MatrixXd(inner), Eigen::VectorXd(wanted));
      for (Eigen::Index k = 0; k < count; ++k) force(free[static_cast<std::size_t>(k)]) = found(k);
    }
    const Few slip = start - mobility * force;
    double worst = 0;
    for (Eigen::Index i = 0, rest = code; i < n; ++i, rest /= 3) {
      const double way = static_cast<double>(rest % 3 - 1);
      const double wrong = way == 0
                               ? std::max(std::abs(slip(i)), mobility(i, i) * (std::abs(force(i)) - limit(i)))
                               : -way * slip(i);
      worst = std::max(worst, wrong);
    }
    stuck = static_cast<int>(count);
    return worst;
  }

  /// The code that satisfies the friction law; tries `guess` first.
  int settle(int guess) {
    const double enough = 1e-12 * (start.cwiseAbs().maxCoeff() + (mobility * limit).maxCoeff());
    int codes = 1;
    for (Eigen::Index i = 0; i < start.size(); ++i) codes *= 3;
    int best = guess;
    double least = guess < codes ? try_code(guess) : std::numeric_limits<double>::infinity();
    for (int code = 0; code < codes && least > enough; ++code) {
      const double wrong = try_code(code);
      if (wrong < least) least = wrong, best = code;
    }
    try_code(best);
    const Few slip = start - mobility * force;
    at_zero = 0;
    for (Eigen::Index i = 0; i < start.size(); ++i) at_zero += std::abs(slip(i)) <= enough;
    return best;
  }
};

class Stepping {
 public:
  Stepping(const scene::Scene& scene, double step_s)
      : scene_(scene),
        h_(step_s),
        stiffness_(scene.structure.stiffness),
        forward_(scene.structure.mass - step_s / 2 * scene.structure.damping),
        inverse_(
            numerics::dense::FullPivotFactors(scene.structure.mass + step_s / 2 * scene.structure.damping)
                .inverse()) {
    for (const scene::Contact& contact : scene.contacts)
      relative_.emplace_back(scene::relative_map(scene.structure, contact));
  }

  void step(Vector& q, Vector& v, double time_s, SteppedTurn& turn) {
    const Vector middle = q + h_ / 2 * v;
    const double phase = scene_.speed_rad_per_s * (time_s + h_ / 2);
    Vector base = forward_ * v +
                  h_ * (scene_.constant_n - stiffness_ * middle + std::cos(phase) * scene_.harmonic_n.real() -
                        std::sin(phase) * scene_.harmonic_n.imag());
    if (scene_.second_harmonic_n.size() > 0)
      base += h_ * (scene_.second_harmonic_n * std::polar(1.0, 2 * phase)).real();
    Vector next = v;
    // The damper's force depends on the mean velocity, so these passes iterate.
    for (int pass = 0; pass < 3; ++pass) next = passed(base, middle, (v + next) / 2, v);
    turn.stuck += friction_.stuck > 0;
    turn.together += friction_.at_zero > 1;
    q = middle + h_ / 2 * next;
    v = next;
  }

 private:
  Vector passed(Vector impulse, const Vector& q, const Vector& v, const Vector& before) {
    // Friction refers to the slip at the end of the step, when the tangent has rotated.
    std::array<Vector, most_contacts> along, along_at_end;
    const Vector end = q + h_ * (v - before / 2);
    std::array<double, most_contacts> limit{}, surface{};
    Eigen::Index dry = 0;
    for (std::size_t i = 0; i < relative_.size(); ++i) {
      const scene::Contact& contact = scene_.contacts[i];
      const Eigen::Vector2d d = relative_[i] * q + contact::offset(contact.wall), w = relative_[i] * v;
      const Eigen::Vector2d normal = contact::normal_at(contact.wall, d);
      if (d.dot(normal) <= contact.clearance_m) continue;
      const Eigen::Vector2d tangent(-normal.y(), normal.x());
      const auto force = contact::elastogap(contact.stiffness_n_per_m, contact.damping_ns_per_m,
                                            d.dot(normal) - contact.clearance_m, w.dot(normal));
      impulse -= h_ * relative_[i].transpose() * (force.total_n * normal);
      const auto at = static_cast<std::size_t>(dry);
      along[at] = relative_[i].transpose() * tangent;
      const Eigen::Vector2d turned =
          contact::normal_at(contact.wall, relative_[i] * end + contact::offset(contact.wall));
      along_at_end[at] = relative_[i].transpose() * Eigen::Vector2d(-turned.y(), turned.x());
      limit[at] = contact::dry_coefficient(contact.friction) * force.spring_n;
      surface[at] = contact.surface_speed_m_per_s;
      ++dry;
    }
    Vector next = inverse_ * impulse;
    friction_.stuck = friction_.at_zero = 0;
    if (dry == 0) return next;
    friction_.mobility.resize(dry, dry);
    friction_.start.resize(dry);
    friction_.limit.resize(dry);
    friction_.force.resize(dry);
    for (Eigen::Index i = 0; i < dry; ++i) {
      const auto at = static_cast<std::size_t>(i);
      friction_.start(i) = along_at_end[at].dot(next) + surface[at];
      friction_.limit(i) = limit[at];
      for (Eigen::Index j = 0; j < dry; ++j)
        friction_.mobility(i, j) = h_ * along_at_end[at].dot(inverse_ * along[static_cast<std::size_t>(j)]);
    }
    guess_ = friction_.settle(guess_);
    for (Eigen::Index i = 0; i < dry; ++i)
      next -= h_ * friction_.force(i) * (inverse_ * along[static_cast<std::size_t>(i)]);
    return next;
  }

  const scene::Scene& scene_;
  double h_;
  Matrix stiffness_, forward_, inverse_;
  std::vector<Eigen::Matrix<double, 2, Eigen::Dynamic>> relative_;
  Friction friction_;
  int guess_ = 0;
};

}  // namespace

SteppedTurn time_stepping_turn(const scene::Scene& scene, const std::vector<double>& section, long steps) {
  const auto n = static_cast<Eigen::Index>(section.size()) / 2;
  const double length = scene.length_scale_m, speed = length * scene.speed_rad_per_s;
  Vector q = Eigen::Map<const Eigen::VectorXd>(section.data(), n) * length,
         v = Eigen::Map<const Eigen::VectorXd>(section.data() + n, n) * speed;
  const double h = scene.period_s() / static_cast<double>(steps);
  Stepping stepping(scene, h);
  SteppedTurn turn;
  for (long k = 0; k < steps; ++k) stepping.step(q, v, h * static_cast<double>(k), turn);
  for (Eigen::Index i = 0; i < n; ++i) turn.section.push_back(q(i) / length);
  for (Eigen::Index i = 0; i < n; ++i) turn.section.push_back(v(i) / speed);
  return turn;
}

}  // namespace rubsweep::audit
