#pragma once

#include <cmath>

#include "rubsweep/core/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::taylor {

/// The contact with its two directions rotated by `angle_rad`.
inline run::ScaledContact<4> turned(run::ScaledContact<4> contact, double angle_rad) {
  const double cosine = std::cos(angle_rad), sine = std::sin(angle_rad);
  const auto turn = [&](auto& first, auto& second) {
    const auto before = first;
    first = cosine * before + sine * second;
    second = cosine * second - sine * before;
  };
  turn(contact.first_row, contact.second_row);
  turn(contact.first_push, contact.second_push);
  return contact;
}

}  // namespace rubsweep::integrate::taylor
