#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <utility>

namespace rubsweep::branch {

/// The last few of what is costly to make, the latest used first: an orbit's scene and its neighbours for
/// derivatives.
template <class T>
class Recent {
 public:
  explicit Recent(std::size_t most) : most_(most) {}

  /// The one that `is` holds for; null where none is kept. It stays until `most` others have been used.
  template <class Is>
  T* find(const Is& is) {
    for (auto one = kept_.begin(); one != kept_.end(); ++one) {
      if (!is(std::as_const(**one))) continue;
      kept_.splice(kept_.begin(), kept_, one);
      return kept_.front().get();
    }
    return nullptr;
  }

  T* keep(std::unique_ptr<T> made) {
    kept_.push_front(std::move(made));
    if (kept_.size() > most_) kept_.pop_back();
    return kept_.front().get();
  }

 private:
  std::size_t most_;
  std::list<std::unique_ptr<T>> kept_;
};

}  // namespace rubsweep::branch
