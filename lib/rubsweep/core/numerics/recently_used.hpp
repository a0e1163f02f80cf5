#pragma once

#include <cstddef>
#include <list>
#include <utility>

namespace rubsweep::numerics {

/// A least-recently-used cache of what is costly to make. What it holds stays where it is in memory until it
/// is dropped.
template <class T>
class RecentlyUsed {
 public:
  /// The sizes of all that is kept come to no more than `most`; a size is one, unless `trim` is told another.
  explicit RecentlyUsed(std::size_t most) : most_(most) {}

  /// The one that `is` holds for, which now is the one used last; null where none is kept.
  template <class Is>
  T* find(const Is& is) {
    for (auto one = kept_.begin(); one != kept_.end(); ++one) {
      if (!is(std::as_const(*one))) continue;
      kept_.splice(kept_.begin(), kept_, one);
      return &kept_.front();
    }
    return nullptr;
  }

  /// Makes one, the one used last. Nothing is dropped before `trim`.
  template <class... Arguments>
  T& emplace(Arguments&&... arguments) {
    return kept_.emplace_front(std::forward<Arguments>(arguments)...);
  }

  /// Drops what was not used for longest until the rest fits; the one used last stays whatever its size.
  template <class Size>
  void trim(const Size& size) {
    std::size_t sum = 0;
    for (auto one = kept_.begin(); one != kept_.end(); ++one) {
      sum += size(std::as_const(*one));
      if (one == kept_.begin() || sum <= most_) continue;
      kept_.erase(one, kept_.end());
      return;
    }
  }
  void trim() {
    trim([](const T&) { return std::size_t{1}; });
  }

  /// The one used last; null where none is kept.
  T* newest() { return kept_.empty() ? nullptr : &kept_.front(); }
  std::size_t size() const { return kept_.size(); }

 private:
  std::size_t most_;
  std::list<T> kept_;
};

}  // namespace rubsweep::numerics
