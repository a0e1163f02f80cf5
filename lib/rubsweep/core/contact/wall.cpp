#include "rubsweep/core/contact/wall.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace rubsweep::contact {
namespace {

/// Long half-axis of the ellipse on which a point moves as Re(amplitude e^{i phase}) about its mean.
double long_half_axis(const Eigen::Vector2cd& amplitude) {
  const std::complex<double> i(0, 1);
  return (std::abs(amplitude.x() + i * amplitude.y()) + std::abs(amplitude.x() - i * amplitude.y())) / 2;
}

}  // namespace

Eigen::Vector2d direction(double angle_deg) {
  const double quarter_turns = angle_deg / 90;
  if (quarter_turns == std::floor(quarter_turns)) {
    constexpr std::array<std::array<double, 2>, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const auto index = static_cast<std::size_t>(std::fmod(std::fmod(quarter_turns, 4) + 4, 4));
    return {exact[index][0], exact[index][1]};
  }
  constexpr double degree = std::numbers::pi / 180;
  return {std::cos(angle_deg * degree), std::sin(angle_deg * degree)};
}

Wall wall_of(const model::StopGeometry& geometry) {
  return std::visit(overloaded{[](const model::OneSideGeometry& flat) -> Wall {
                                 return FlatWall{direction(flat.angle_deg)};
                               },
                               [](const model::AnnularGeometry& annular) -> Wall {
                                 return AnnularWall{{annular.offset_m[0], annular.offset_m[1]}};
                               }},
                    geometry);
}

std::string describe(const model::StopGeometry& geometry) {
  return std::visit(overloaded{[](const model::OneSideGeometry& flat) {
                                 return fmt::format("one side at {} degrees", flat.angle_deg);
                               },
                               [](const model::AnnularGeometry& annular) -> std::string {
                                 const auto& offset_m = annular.offset_m;
                                 if (offset_m[0] == 0 && offset_m[1] == 0) return "annular, centred";
                                 return fmt::format("annular, rotor offset by ({}, {}) m", offset_m[0],
                                                    offset_m[1]);
                               }},
                    geometry);
}

Wall in_units(const Wall& wall, double unit) {
  return std::visit(
      overloaded{[](const FlatWall& flat) -> Wall { return flat; },
                 [&](const AnnularWall& annular) -> Wall { return AnnularWall{annular.offset / unit}; }},
      wall);
}

bool same(const Wall& a, const Wall& b) {
  return a.index() == b.index() &&
         std::visit(
             overloaded{[&](const FlatWall& x) { return x.normal == std::get<FlatWall>(b).normal; },
                        [&](const AnnularWall& x) { return x.offset == std::get<AnnularWall>(b).offset; }},
             a);
}

bool centred(const Wall& wall) {
  return std::visit(overloaded{[](const FlatWall&) { return false; },
                               [](const AnnularWall& annular) { return annular.offset.isZero(0); }},
                    wall);
}

Eigen::Vector2d offset(const Wall& wall) {
  return std::visit(overloaded{[](const FlatWall&) -> Eigen::Vector2d {
                                 return {0, 0};
                               },
                               [](const AnnularWall& annular) -> Eigen::Vector2d { return annular.offset; }},
                    wall);
}

Eigen::Vector2d first_direction(const Wall& wall) {
  return std::visit(overloaded{[](const FlatWall& flat) -> Eigen::Vector2d { return flat.normal; },
                               [](const AnnularWall&) -> Eigen::Vector2d {
                                 return {1, 0};
                               }},
                    wall);
}

Eigen::Vector2d normal_at(const Wall& wall, const Eigen::Vector2d& distance) {
  return std::visit(overloaded{[](const FlatWall& flat) -> Eigen::Vector2d { return flat.normal; },
                               [&](const AnnularWall&) -> Eigen::Vector2d {
                                 if (distance.isZero(0)) return {0, 1};
                                 return distance.normalized();
                               }},
                    wall);
}

double penetration_at(const Wall& wall, const Eigen::Vector2d& distance, double clearance) {
  return std::visit(
      overloaded{[&](const FlatWall& flat) { return flat.normal.dot(distance) - clearance; },
                 [&](const AnnularWall&) { return normal_at(wall, distance).dot(distance) - clearance; }},
      wall);
}

Outline outline(const Wall& wall, double clearance) {
  return std::visit(
      overloaded{[&](const FlatWall& flat) -> Outline { return {.normal = flat.normal, .reach = clearance}; },
                 [&](const AnnularWall& annular) -> Outline {
                   return {.circle = true, .centre = -annular.offset, .reach = clearance};
                 }},
      wall);
}

Eigen::MatrixXd rows_against(const Wall& wall, const RelativeMap& relative) {
  return std::visit(
      overloaded{[&](const FlatWall& flat) -> Eigen::MatrixXd { return flat.normal.transpose() * relative; },
                 [&](const AnnularWall&) -> Eigen::MatrixXd { return relative; }},
      wall);
}

Excursion excursion(const Wall& wall, double clearance, const RelativeMap& relative,
                    const Eigen::VectorXd& mean, const Eigen::VectorXcd& amplitude) {
  return std::visit(
      overloaded{[&](const FlatWall& flat) -> Excursion {
                   const Eigen::RowVectorXd row = flat.normal.transpose() * relative;
                   const std::complex<double> normal = row.cast<std::complex<double>>() * amplitude;
                   return {row.dot(mean) - clearance, std::abs(normal)};
                 },
                 [&](const AnnularWall& annular) -> Excursion {
                   const Eigen::Vector2cd swing = relative.cast<std::complex<double>>() * amplitude;
                   const Eigen::Vector2d middle = relative * mean + annular.offset;
                   return {middle.norm() - clearance, long_half_axis(swing)};
                 }},
      wall);
}

double share_of_way_to(const Wall& wall, double clearance, const Eigen::Vector2d& way) {
  constexpr double never = std::numeric_limits<double>::infinity();
  return std::visit(overloaded{[&](const FlatWall& flat) {
                                 const double along = flat.normal.dot(way);
                                 return along > 0 ? clearance / along : never;
                               },
                               [&](const AnnularWall& annular) {
                                 // |s way + offset| = clearance: a s^2 + 2 b s = c with c > 0, solved in the
                                 // form without cancellation.
                                 const double a = way.squaredNorm(), b = way.dot(annular.offset);
                                 const double c = clearance * clearance - annular.offset.squaredNorm();
                                 const double root = std::sqrt(b * b + a * c);
                                 if (!(a > 0)) return never;
                                 return b > 0 ? c / (b + root) : (root - b) / a;
                               }},
                    wall);
}

}  // namespace rubsweep::contact
