#pragma once

namespace rubsweep {

/// Joins several callables into one for std::visit. A variant with a new alternative then does not compile
/// until each visitor handles it.
template <class... Callables>
struct overloaded : Callables... {
  using Callables::operator()...;
};

template <class... Callables>
overloaded(Callables...) -> overloaded<Callables...>;

}  // namespace rubsweep
