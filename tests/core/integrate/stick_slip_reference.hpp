#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace rubsweep::test {

/// One mass in a plane on a spring and a damper, driven by a rotating force between walls with static
/// friction. It uses long double, fixed steps of Gragg's extrapolated midpoint rule and regula falsi for
/// events, and tries every combination of sticking walls. It shares no code with the library.
class StickSlipReference {
 public:
  using Real = long double;
  using State = std::array<Real, 4>;  ///< x, y and their rates

  struct Wall {
    bool ring = false;
    Real x = 1, y = 0;  ///< normal of a flat wall; offset in a ring
    Real clearance = 1, stiffness = 1, damping = 0, surface_speed = 0;
    Real holds = 0, slides = 0;  ///< static and sliding coefficients of friction
    Real fall_speed = 0;         ///< 0: friction drops at once
    int power = 1;
  };

  Real mass = 1, spring = 1, damper = 0, turns_at = 1, force = 0, constant_x = 0, constant_y = 0;
  std::vector<Wall> walls;
  State state{};
  Real step = 0;
  int stops = 0, releases = 0, together = 0;  ///< ends and starts of slips; events of two or more at once

  void begin() {
    contacts_.assign(walls.size(), {});
    for (std::size_t i = 0; i < walls.size(); ++i) contacts_[i].zone = zone_of(i);
    std::vector<std::size_t> standing;
    for (std::size_t i = 0; i < walls.size(); ++i) touch(i, standing);
    settle(standing, walls.size());
  }

  void go(Real duration) {
    for (Real left = duration; left > 0;) left -= advance(std::min(step, left));
  }

 private:
  enum class Zone { open, clamped, sprung, released };
  struct Contact {
    Zone zone = Zone::open;
    int way = 0;  ///< direction of the slip; 0: sticking
  };
  struct Look {
    Real nx, ny, radius, depth, closing, sliding, slip;
  };
  struct Vector {
    Real x = 0, y = 0;
  };
  static constexpr Real rounding = 1e-15L;

  Look look(std::size_t i, const State& s) const {
    const Wall& w = walls[i];
    Look l{};
    Real x = s[0], y = s[1];
    l.nx = w.x, l.ny = w.y;
    if (w.ring) {
      x += w.x, y += w.y;
      l.radius = std::hypot(x, y);
      l.nx = x / l.radius, l.ny = y / l.radius;
    }
    l.depth = x * l.nx + y * l.ny - w.clearance;
    l.closing = l.nx * s[2] + l.ny * s[3];
    l.sliding = l.nx * s[3] - l.ny * s[2];
    l.slip = l.sliding + w.surface_speed;
    return l;
  }

  Zone zone_of(std::size_t i) const {
    const Look l = look(i, state);
    const Real spring_n = walls[i].stiffness * l.depth, damper_n = walls[i].damping * l.closing;
    if (l.depth <= 0) return Zone::open;
    return damper_n >= spring_n ? Zone::clamped : spring_n + damper_n <= 0 ? Zone::released : Zone::sprung;
  }

  /// Friction coefficient of a wall that slips in the direction `way`.
  static Real coefficient(const Wall& w, Real slip, int way) {
    if (w.fall_speed == 0) return way * w.slides;
    return way * (w.slides + (w.holds - w.slides) * std::exp(-std::pow(way * slip / w.fall_speed, w.power)));
  }

  bool touches(std::size_t i) const { return contacts_[i].zone != Zone::open; }
  bool sticks(std::size_t i) const { return touches(i) && contacts_[i].way == 0; }

  /// Acceleration without the friction of the sticking walls.
  Vector loose(const State& s, Real t) const {
    Vector a{constant_x + force * std::cos(turns_at * t) - spring * s[0] - damper * s[2],
             constant_y + force * std::sin(turns_at * t) - spring * s[1] - damper * s[3]};
    for (std::size_t i = 0; i < walls.size(); ++i) {
      if (!touches(i)) continue;
      const Wall& w = walls[i];
      const Look l = look(i, s);
      const Real spring_n = w.stiffness * l.depth;
      Real normal = 2 * spring_n;
      if (contacts_[i].zone == Zone::sprung) normal = spring_n + w.damping * l.closing;
      if (contacts_[i].zone == Zone::released) normal = 0;
      const Real friction = contacts_[i].way == 0 ? 0 : coefficient(w, l.slip, contacts_[i].way) * spring_n;
      a.x -= l.nx * normal - l.ny * friction;
      a.y -= l.ny * normal + l.nx * friction;
    }
    return {a.x / mass, a.y / mass};
  }

  static Real slip_rate(const Look& l, Vector a, bool ring) {
    return l.nx * a.y - l.ny * a.x - (ring ? l.closing * l.sliding / l.radius : 0);
  }

  /// Friction forces that keep the slips of one or two walls unchanged, by Cramer's rule.
  std::vector<Real> holding(const std::vector<std::size_t>& which, const State& s, Vector a) const {
    std::vector<Look> l;
    std::vector<Real> need, f(which.size(), 0);
    for (const std::size_t i : which) {
      l.push_back(look(i, s));
      need.push_back(mass * slip_rate(l.back(), a, walls[i].ring));
    }
    if (which.size() == 1) f[0] = need[0];
    if (which.size() == 2) {
      const Real c = l[0].nx * l[1].nx + l[0].ny * l[1].ny, d = 1 - c * c;
      f = {(need[0] - c * need[1]) / d, (need[1] - c * need[0]) / d};
    }
    return f;
  }

  std::vector<std::size_t> stuck() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < walls.size(); ++i) {
      if (sticks(i)) all.push_back(i);
    }
    return all;
  }

  State rate(const State& s, Real t) const {
    Vector a = loose(s, t);
    const std::vector<std::size_t> held = stuck();
    const std::vector<Real> f = holding(held, s, a);
    for (std::size_t k = 0; k < held.size(); ++k) push(a, look(held[k], s), f[k]);
    return {s[2], s[3], a.x, a.y};
  }

  void push(Vector& a, const Look& l, Real friction) const {
    a.x += l.ny * friction / mass;
    a.y -= l.nx * friction / mass;
  }

  State after(Real h) const {
    constexpr int columns = 8;
    std::array<State, columns> row{}, last{};
    for (int j = 0; j < columns; ++j, last = row) {
      row[0] = midpoint(h, 2 * (j + 1));
      for (int i = 1; i <= j; ++i) {
        const Real ratio = static_cast<Real>(j + 1) / (j + 1 - i);
        const auto at = static_cast<std::size_t>(i);
        for (std::size_t k = 0; k < 4; ++k)
          row[at][k] = row[at - 1][k] + (row[at - 1][k] - last[at - 1][k]) / (ratio * ratio - 1);
      }
    }
    return row.back();
  }

  State midpoint(Real h, int parts) const {
    const Real d = h / parts;
    State before = state, now = state;
    const auto add = [](State& to, Real share, const State& slope) {
      for (std::size_t k = 0; k < 4; ++k) to[k] += share * slope[k];
    };
    add(now, d, rate(state, time_));
    for (int m = 1; m < parts; ++m) {
      add(before, 2 * d, rate(now, time_ + m * d));
      std::swap(before, now);
    }
    const State slope = rate(now, time_ + h);
    for (std::size_t k = 0; k < 4; ++k) now[k] = (before[k] + now[k] + d * slope[k]) / 2;
    return now;
  }

  /// Function that rises through zero at an event.
  struct Guard {
    std::size_t wall = 0;
    Zone next = Zone::open;
    int way = 0;   ///< direction of the slip after a release
    int kind = 0;  ///< 0: penetration, 1: stop of a slip, 2: release
    Real value = 0;
  };

  std::vector<Guard> guards(const State& s, Real t) const {
    std::vector<Guard> all;
    const std::vector<std::size_t> held = stuck();
    const std::vector<Real> f = holding(held, s, loose(s, t));
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const Wall& w = walls[i];
      const Look l = look(i, s);
      const Real spring_n = w.stiffness * l.depth, damper_n = w.damping * l.closing;
      const bool damped = w.damping > 0;
      switch (contacts_[i].zone) {
        case Zone::open: all.push_back({i, damped ? Zone::clamped : Zone::sprung, 0, 0, l.depth}); continue;
        case Zone::clamped: all.push_back({i, Zone::sprung, 0, 0, spring_n - damper_n}); break;
        case Zone::sprung:
          if (damped) {
            all.push_back({i, Zone::clamped, 0, 0, damper_n - spring_n});
            all.push_back({i, Zone::released, 0, 0, -spring_n - damper_n});
          } else {
            all.push_back({i, Zone::open, 0, 0, -l.depth});
          }
          break;
        case Zone::released:
          all.push_back({i, Zone::open, 0, 0, -l.depth});
          all.push_back({i, Zone::sprung, 0, 0, spring_n + damper_n});
          break;
      }
      if (!sticks(i)) {
        all.push_back({i, {}, 0, 1, -contacts_[i].way * l.slip});
        continue;
      }
      const auto k = static_cast<std::size_t>(std::find(held.begin(), held.end(), i) - held.begin());
      for (const int way : {1, -1}) all.push_back({i, {}, way, 2, way * f[k] - w.holds * spring_n});
    }
    return all;
  }

  /// Advances by `h`, or up to the first event before that.
  Real advance(Real h) {
    const std::vector<Guard> before = guards(state, time_);
    State end = after(h);
    std::vector<Guard> ends = guards(end, time_ + h);
    Real first = h;
    std::size_t event = before.size();
    for (std::size_t g = 0; g < before.size(); ++g) {
      if (!(ends[g].value > 0)) continue;
      const Real at = root(g, std::min<Real>(before[g].value, -rounding * rounding), h, ends[g].value);
      if (at <= first) first = at, event = g;
    }
    if (event < before.size()) end = after(first);
    state = end;
    time_ += first;
    if (event < before.size()) apply(before[event]);
    return first;
  }

  /// Root by regula falsi, Illinois variant.
  Real root(std::size_t guard, Real low_value, Real high, Real high_value) const {
    Real low = 0;
    for (int k = 0, side = 0; k < 80 && high - low > 1e-17L * step; ++k) {
      const Real at = (low * high_value - high * low_value) / (high_value - low_value);
      const Real value = guards(after(at), time_ + at)[guard].value;
      if (value > 0) {
        high = at, high_value = value;
        if (side == 1) low_value /= 2;
        side = 1;
      } else {
        low = at, low_value = value;
        if (value == 0) return at;
        if (side == -1) high_value /= 2;
        side = -1;
      }
    }
    return high;
  }

  void apply(const Guard& event) {
    Contact& c = contacts_[event.wall];
    std::vector<std::size_t> standing = stuck();
    if (event.kind == 0) {
      const bool begins = c.zone == Zone::open;
      c.zone = event.next;
      if (!begins) return;
      const std::size_t before = standing.size();
      touch(event.wall, standing);
      if (standing.size() > before) settle(standing, walls.size());
      return;
    }
    const Wall& w = walls[event.wall];
    (event.kind == 1 ? stops : releases) += 1;
    if (event.kind == 1) {
      standing.push_back(event.wall);
      settle(standing, walls.size());
    } else if (w.fall_speed > 0 || w.holds == w.slides) {
      c.way = event.way;
    } else {
      settle(standing, event.wall);
    }
  }

  /// Sets the direction of slip of a touching wall; a wall with slip zero is added to the walls that may
  /// stick.
  void touch(std::size_t i, std::vector<std::size_t>& standing) {
    const Real slip = look(i, state).slip;
    if (!touches(i)) return;
    contacts_[i].way = slip > 0 ? 1 : -1;
    if (std::abs(slip) < rounding) standing.push_back(i);
  }

  /// Chooses the sticking walls by trying all sets and directions, first with the static limits. Walls that
  /// then slip, and `let_go` from the beginning, get the sliding friction as their limit, and all sets are
  /// tried again.
  void settle(const std::vector<std::size_t>& standing, std::size_t let_go) {
    if (standing.empty()) return;
    std::vector<Real> bound;
    for (const std::size_t i : standing) {
      const Wall& w = walls[i];
      bound.push_back((i == let_go ? w.slides : w.holds) * w.stiffness * look(i, state).depth);
    }
    for (bool narrowed = true; narrowed;) {
      narrowed = false;
      choose(standing, bound);
      for (std::size_t k = 0; k < standing.size(); ++k) {
        const Wall& w = walls[standing[k]];
        const Real slides = w.slides * w.stiffness * look(standing[k], state).depth;
        if (contacts_[standing[k]].way == 0 || w.fall_speed > 0 || bound[k] <= slides) continue;
        bound[k] = slides;
        narrowed = true;
      }
    }
    int moving = 0;
    for (const std::size_t i : standing) moving += contacts_[i].way != 0;
    together += moving > 1;
  }

  void choose(const std::vector<std::size_t>& standing, const std::vector<Real>& bound) {
    int all = 1;
    for (std::size_t k = 0; k < standing.size(); ++k) all *= 3;
    for (const std::size_t i : standing) contacts_[i].way = 0;
    const Vector free = loose(state, time_);
    for (int code = 0; code < all; ++code) {
      std::vector<std::size_t> held;
      std::vector<int> ways(standing.size(), 0);
      Vector a = free;
      for (std::size_t k = 0, rest = static_cast<std::size_t>(code); k < standing.size(); ++k, rest /= 3) {
        ways[k] = rest % 3 == 2 ? -1 : static_cast<int>(rest % 3);
        if (ways[k] == 0) held.push_back(standing[k]);
        push(a, look(standing[k], state), ways[k] * bound[k]);
      }
      if (held.size() > 2) continue;
      const std::vector<Real> f = holding(held, state, a);
      for (std::size_t k = 0; k < held.size(); ++k) push(a, look(held[k], state), f[k]);
      bool lawful = true;
      for (std::size_t k = 0, h = 0; k < standing.size(); ++k) {
        const Look l = look(standing[k], state);
        const Real size = 1 + std::abs(free.x) + std::abs(free.y);
        lawful =
            lawful && (ways[k] == 0 ? std::abs(f[h++]) <= bound[k]
                                    : ways[k] * slip_rate(l, a, walls[standing[k]].ring) >= -rounding * size);
      }
      if (!lawful) continue;
      for (std::size_t k = 0; k < standing.size(); ++k) contacts_[standing[k]].way = ways[k];
      return;
    }
  }

  std::vector<Contact> contacts_;
  Real time_ = 0;
};

}  // namespace rubsweep::test
