#include "rubsweep/core/integrate/taylor/contact_directions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <variant>

#include "core/integrate/taylor/set_c_scene.hpp"
#include "core/integrate/taylor/turned_contact.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using numerics::Twin;

const Eigen::Vector4d moved{0.3, -1.7, 0.9, 2.3};
const Eigen::Vector2d force{-0.7, 1.9};

run::ScaledContact<4> annular() { return run::scale<4>(set_c_scene(80, 0.6)).contacts[0]; }

/// `seen`: projection of `moved` onto the contact's directions; `moved` afterwards includes the effect of the
/// force.
struct Made {
  Eigen::Vector2d seen;
  Eigen::Vector4d pushed;
};

template <class Directions>
Made made_by(const Directions& directions) {
  const typename Directions::Force push(Twin{force[0], force[1]});
  typename Directions::Seen seen{};
  Made made;
  for (std::size_t pair = 0; pair < 2; ++pair) {
    const auto i = static_cast<Eigen::Index>(2 * pair);
    const Twin terms{moved[i], moved[i + 1]};
    directions.see(pair, terms, seen);
    const Twin pushed = directions.pushed(pair, terms, push);
    made.pushed.segment<2>(i) << pushed[0], pushed[1];
  }
  const Twin total = directions.total(seen, push);
  made.seen << total[0], total[1];
  return made;
}

TEST(ContactDirections, SeeAndPushAsRowsAndColumnsSay) {
  const auto c = turned(annular(), 0.4);
  const Eigen::Vector4d push = force[0] * c.first_push + force[1] * c.second_push, total = moved + push;
  const Made made = made_by(AnyDirections<4>(c));
  EXPECT_LT((made.pushed - total).norm(), 1e-14);
  EXPECT_LT((made.seen - Eigen::Vector2d(c.first_row.dot(total), c.second_row.dot(total))).norm(), 1e-14);
}

TEST(ContactDirections, AlongTheAxesGiveTheSameBits) {
  const auto c = annular();
  const auto axes = AxisDirections<4>::of(c);
  ASSERT_TRUE(axes);
  const Made here = made_by(*axes), there = made_by(AnyDirections<4>(c));
  EXPECT_EQ(here.seen, there.seen);
  EXPECT_EQ(here.pushed, there.pushed);
}

TEST(ContactDirections, AreTakenAsTheyLie) {
  EXPECT_TRUE(std::holds_alternative<AxisDirections<4>>(directions_of(annular())));
  EXPECT_TRUE(std::holds_alternative<AnyDirections<4>>(directions_of(turned(annular(), 0.4))));
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
