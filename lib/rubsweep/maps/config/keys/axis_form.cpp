#include "rubsweep/maps/config/keys/axis_form.hpp"

#include "rubsweep/maps/config/keys/fields.hpp"

namespace rubsweep::config::keys {
namespace {

constexpr std::size_t most_values = 10'000, most_keys = 100;

}  // namespace

std::vector<Key> spaced_keys(const model::Range& range) {
  Form values = list_of(number(range), 1, most_values);
  values.different = true;
  return joined({{must("from", number(range), "first value"),
                  may("to", number(range), "last value, included", "(from, of a count of 1)"),
                  must("count", integer(1, most_values), "how many values there are, both ends included")},
                 newer({may("scale", word({"linear", "log"}),
                            "spacing: equal differences, or equal ratios of values > 0", "linear"),
                        must("step", number(model::positive),
                             "distance between the values, in place of their count: each is the double "
                             "nearest to its decimal")}),
                 {must("values", values, "the values themselves, all different")}});
}

Choice spaced_ways() {
  return {{{{"values"}, {}}, {{"from", "count"}, {"to", "scale"}}, {{"from", "to", "step"}, {}}}};
}

Form axis(const model::Range& range) {
  return any_of({number(range), map_of(spaced_keys(range), {spaced_ways()})});
}

std::vector<Key> key_axis_keys() {
  return newer({must("key", text(), "key of a number of the configuration, as --set names it"),
                must("keys", list_of(text(), 1, most_keys), "several keys that change together"),
                may("factors", list_of(number({}), 1, most_keys), "share of each key in the value, in order",
                    "(all 1)")});
}

Choice key_axis_ways() { return {{{{"key"}, {"factors"}}, {{"keys"}, {"factors"}}}}; }

}  // namespace rubsweep::config::keys
