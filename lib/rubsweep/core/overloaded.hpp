#pragma once

namespace rubsweep {

/// One callable from several, for std::visit: a variant with one more alternative fails to compile wherever
/// nobody has said what that means.
template <class... Callables>
struct overloaded : Callables... {
  using Callables::operator()...;
};

template <class... Callables>
overloaded(Callables...) -> overloaded<Callables...>;

}  // namespace rubsweep
