#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace rubsweep::numerics {

/// Makes the processor treat subnormal numbers as zero on this thread during the object's lifetime. A
/// decaying vibration finally becomes subnormal: the smallest such number times 0.9 rounds back to itself,
/// and every operation on it takes a hundred times as long. Compared with the other numbers of a motion,
/// 1e-308 does not matter. Does nothing on an unknown processor.
class FlushSubnormals {
 public:
  FlushSubnormals() : before_(control()) { set_control(before_ | flush); }
  ~FlushSubnormals() { set_control(before_); }
  FlushSubnormals(const FlushSubnormals&) = delete;
  FlushSubnormals& operator=(const FlushSubnormals&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr unsigned int flush = 0x8040;  ///< flush results to zero, treat operands as zero
  static unsigned int control() { return _mm_getcsr(); }
  static void set_control(unsigned int control) { _mm_setcsr(control); }
#else
  static constexpr unsigned int flush = 0;
  static unsigned int control() { return 0; }
  static void set_control(unsigned int) {}
#endif

  unsigned int before_;
};

}  // namespace rubsweep::numerics
