#pragma once

#include <cstddef>
#include <list>
#include <utility>

namespace rubsweep::numerics {

/// A least-recently-used cache of costly objects. An object keeps its address until it is dropped.
template <class T>
class RecentlyUsed {
 public:
  /// `most`: largest total size of the kept objects; each has size 1 unless `trim` gets another measure.
  explicit RecentlyUsed(std::size_t most) : most_(most) {}

  /// Finds the object for which `is` holds and makes it the most recent; null where there is none.
  template <class Is>
  T* find(const Is& is) {
    for (auto one = kept_.begin(); one != kept_.end(); ++one) {
      if (!is(std::as_const(*one))) continue;
      kept_.splice(kept_.begin(), kept_, one);
      return &kept_.front();
    }
    return nullptr;
  }

  /// Makes an object, which becomes the most recent. Nothing is dropped before `trim`.
  template <class... Arguments>
  T& emplace(Arguments&&... arguments) {
    return kept_.emplace_front(std::forward<Arguments>(arguments)...);
  }

  /// Drops objects, least recent first, until the remaining ones fit; the most recent object always stays.
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

  /// The most recent object; null where there is none.
  T* newest() { return kept_.empty() ? nullptr : &kept_.front(); }
  std::size_t size() const { return kept_.size(); }

 private:
  std::size_t most_;
  std::list<T> kept_;
};

}  // namespace rubsweep::numerics
