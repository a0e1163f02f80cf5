#include "rubsweep/response/student_quantile.hpp"

#include <boost/math/distributions/students_t.hpp>

namespace rubsweep::response {

double student_quantile(std::size_t degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(static_cast<double>(degrees_of_freedom)), 0.995);
}

}  // namespace rubsweep::response
