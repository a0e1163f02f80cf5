#include "rubsweep/analysis/branch/continuation/continuation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"

namespace rubsweep::branch::continuation {
namespace {

/// The circle x^2 + y^2 = radius^2 as a continuation problem without orbits.
struct Circle {
  double radius = 1, lowest = -2;
};

/// A point of the circle. Argument-dependent lookup finds its function for the position, and does not hide
/// the function of orbits.
struct CirclePoint {
  Eigen::VectorXd at, tangent;
  double arclength = 0;

  friend const Eigen::VectorXd& position_of(const Circle&, const CirclePoint& point) { return point.at; }
};

struct CircleCorrection : NewtonOutcome {
  Eigen::VectorXd at;

  friend const Eigen::VectorXd& position_of(const Circle&, const CircleCorrection& found) { return found.at; }
};

const Eigen::VectorXd& nearest_image(const Circle&, const Eigen::VectorXd& at, const CirclePoint&) {
  return at;
}

CircleCorrection correct_across(const Circle& circle, const Eigen::VectorXd& guess,
                                const Eigen::VectorXd& direction) {
  CircleCorrection found;
  found.at = guess;
  const Eigen::Vector2d across(-direction(1), direction(0));
  for (; found.iterations < 20 && !found.converged; ++found.iterations) {
    const double defect = found.at.squaredNorm() - circle.radius * circle.radius;
    found.at -= defect / (2 * found.at.dot(across)) * across;
    found.converged = std::abs(defect) < 1e-14;
  }
  return found;
}

CircleCorrection correct_between(const Circle& circle, const Eigen::VectorXd& guess, const CirclePoint& from,
                                 const CirclePoint&) {
  return correct_across(circle, guess, from.tangent);
}

std::optional<CirclePoint> completed(const Circle&, const CircleCorrection& found,
                                     const Eigen::VectorXd& direction, double arclength) {
  Eigen::VectorXd tangent = Eigen::Vector2d(-found.at(1), found.at(0)).normalized();
  if (tangent.dot(direction) < 0) tangent = -tangent;
  return CirclePoint{found.at, tangent, arclength};
}

CirclePoint turned_about(CirclePoint point) {
  point.tangent = -point.tangent;
  return point;
}

struct Crossing {
  CirclePoint point;
};

struct HalfCircle {
  std::vector<CirclePoint> points;
  std::vector<Crossing> events;
  Ending ending = Ending::left_range;
};

/// Continuation task whose events are crossings of x = 0, within the range y >= lowest.
class CircleTask {
 public:
  using Point = CirclePoint;
  using Half = HalfCircle;
  using Correction = CircleCorrection;
  static constexpr int easy_iterations = 6;

  explicit CircleTask(const Circle& circle) : circle_(circle) {}
  const Circle& problem() const { return circle_; }
  bool holds(const CircleCorrection& found) const { return found.at(1) >= circle_.lowest; }

  std::optional<CircleCorrection> correct_at_edge(const CirclePoint& here,
                                                  const CircleCorrection& found) const {
    if (here.at(1) == circle_.lowest) return std::nullopt;
    CircleCorrection edge = found;
    const double x = std::sqrt(circle_.radius * circle_.radius - circle_.lowest * circle_.lowest);
    edge.at = Eigen::Vector2d(std::copysign(x, found.at(0)), circle_.lowest);
    return edge;
  }

  std::optional<Ending> refuses(const CirclePoint&, const CirclePoint& next) const {
    return next.at(1) > refused_above ? std::optional(Ending::infeasible) : std::nullopt;
  }

  static void prepare(CirclePoint&) {}

  std::optional<std::vector<Crossing>> events_between(const CirclePoint& from, const CirclePoint& to) const {
    std::vector<Crossing> crossings;
    if ((from.at(0) < 0) != (to.at(0) < 0)) crossings.push_back({to});
    return crossings;
  }

  std::optional<Ending> ending_at(const CirclePoint&, const Crossing&) const {
    return ends_at_crossing ? std::optional(Ending::target) : std::nullopt;
  }

  static std::vector<Eigen::VectorXd> images(const CirclePoint& point) { return {point.at}; }

  bool ends_at_crossing = false;
  double refused_above = 2;

 private:
  const Circle& circle_;
};

struct Steps {
  double first_step = 0.01, longest_step = 0.2, shortest_step = 1e-6;
  int most_points = 1000;
};

const CirclePoint east{Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), 0};

TEST(Continuation, AClosedCurveIsFollowedOnce) {
  const Circle circle;
  const auto [all, backward] = continue_both_ways(CircleTask(circle), east, Steps{});
  EXPECT_EQ(all.ending, Ending::closed);
  EXPECT_EQ(backward, Ending::closed);
  EXPECT_EQ(all.events.size(), 2u) << "north and south";
  EXPECT_NEAR((all.points.back().at - east.at).norm(), 0, 1e-7);
  EXPECT_NEAR(all.points.back().arclength, 2 * std::numbers::pi, 0.1);
  for (const CirclePoint& point : all.points) EXPECT_NEAR(point.at.norm(), 1, 1e-13);
}

TEST(Continuation, BothWaysToTheEdgesOfTheRange) {
  const Circle circle{1, -0.5};
  const auto [all, backward] = continue_both_ways(CircleTask(circle), east, Steps{});
  EXPECT_EQ(all.ending, Ending::left_range);
  EXPECT_EQ(backward, Ending::left_range);
  EXPECT_EQ(all.points.front().at(1), -0.5);
  EXPECT_EQ(all.points.back().at(1), -0.5);
  EXPECT_GT(all.points.front().at(0), 0);
  EXPECT_LT(all.points.back().at(0), 0);
  for (std::size_t i = 1; i < all.points.size(); ++i) {
    EXPECT_LT(all.points[i - 1].arclength, all.points[i].arclength);
    EXPECT_GT(all.points[i - 1].tangent.dot(all.points[i].tangent), 0) << "one direction throughout";
  }
}

TEST(Continuation, EndsAtAnEventARefusalAndTheLimitOfPoints) {
  const Circle circle;
  CircleTask task(circle);
  task.ends_at_crossing = true;
  const HalfCircle to_event = Continuation<CircleTask>(task, east, Steps{}).run();
  EXPECT_EQ(to_event.ending, Ending::target);
  EXPECT_EQ(to_event.points.back().at, to_event.events.back().point.at);
  task.refused_above = 0.5;
  const HalfCircle refused = Continuation<CircleTask>(task, east, Steps{}).run();
  EXPECT_EQ(refused.ending, Ending::infeasible);
  EXPECT_NEAR(refused.points.back().at(1), 0.5, 1e-5) << "as near as the shortest step comes";
  Steps few;
  few.most_points = 4;
  const HalfCircle limited = Continuation<CircleTask>(task, east, few).run();
  EXPECT_EQ(limited.ending, Ending::point_limit);
  EXPECT_EQ(limited.points.size(), 4u);
}

constexpr double straight = 1, gentle = 0.96, sharp = 0.9;

TEST(Continuation, StepsGrowWhereItIsEasyAndShrinkToTheEnd) {
  FollowOptions options;
  options.first_step = 0.1;
  options.longest_step = 0.2;
  options.shortest_step = 1e-3;
  StepControl steps(options);
  steps.lengthen(straight, true);
  EXPECT_DOUBLE_EQ(steps.step(), 0.15);
  steps.lengthen(straight, false);
  steps.lengthen(gentle, true);
  EXPECT_DOUBLE_EQ(steps.step(), 0.15);
  steps.lengthen(straight, true);
  EXPECT_DOUBLE_EQ(steps.step(), 0.2) << "the longest";
  EXPECT_TRUE(steps.turns_sharply(sharp));
  EXPECT_FALSE(steps.turns_sharply(gentle));
  EXPECT_TRUE(steps.is_far(0.05));
  EXPECT_FALSE(steps.is_far(0.03));
  int halves = 1;
  while (steps.shorten()) ++halves;
  EXPECT_EQ(halves, 8) << "0.2 / 2^8 is the first one below 1e-3";
  EXPECT_FALSE(steps.turns_sharply(sharp)) << "so near, a corner is gone round";
}

}  // namespace
}  // namespace rubsweep::branch::continuation
