#pragma once

#include <gtest/gtest.h>

#include <string>

/// Runs `act`, which must throw an exception of type Error, and returns its message.
template <typename Error>
std::string message_of(const auto& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}
