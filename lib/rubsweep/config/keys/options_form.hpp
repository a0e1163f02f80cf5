#pragma once

#include "rubsweep/config/keys/form.hpp"

namespace rubsweep::config::keys {

Form solver_form();
Form response_form();

}  // namespace rubsweep::config::keys
