#include "rubsweep/maps/config/study_digest.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include "rubsweep/maps/config/print_config.hpp"

namespace rubsweep::config {

std::string digest_of(std::string_view text) {
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  return boost::uuids::to_string(generator(std::string(text)));
}

std::string study_digest(const sweep::Study& study) { return digest_of(print_study(study)); }

}  // namespace rubsweep::config
