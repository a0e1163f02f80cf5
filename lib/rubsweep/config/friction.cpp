#include "rubsweep/config/friction.hpp"

#include <variant>

#include "rubsweep/config/section.hpp"

namespace rubsweep::config {
namespace {

constexpr std::string_view none = "none";
constexpr std::string_view forms = "none, or a map with stribeck or coefficient";

}  // namespace

model::Friction read_friction(const Value& value) {
  if (value.node.kind == Node::Kind::scalar) {
    read_word(value, {&none, 1}, forms);
    return model::NoFriction{};
  }
  Section section(value, forms);
  model::Friction friction;
  section.require_exactly_one({"stribeck", "coefficient"});
  if (const auto stribeck = section.find("stribeck")) {
    read_numbers(*stribeck, friction.emplace<model::StribeckFriction>().gamma);
  }
  if (const auto coefficient = section.find("coefficient")) {
    const auto number = read_number(*coefficient, model::ConstantFriction::coefficient_range);
    friction = model::ConstantFriction{number.value_or(0)};
  }
  section.refuse_unknown_keys();
  return friction;
}

void print_friction(Printer& printer, const model::Friction& friction) {
  if (std::holds_alternative<model::NoFriction>(friction)) {
    printer.word("friction", none);
    return;
  }
  printer.open("friction");
  if (const auto* stribeck = std::get_if<model::StribeckFriction>(&friction)) {
    printer.numbers("stribeck", stribeck->gamma);
  } else {
    printer.number("coefficient", std::get<model::ConstantFriction>(friction).coefficient);
  }
  printer.close();
}

}  // namespace rubsweep::config
