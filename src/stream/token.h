#pragma once

#include <string>
#include <string_view>

namespace aeolic::stream {

/// 192 random bits, as 32 characters that need no escaping in a URL. Throws std::runtime_error where the system has no
/// random numbers.
std::string makeToken();

/// Compares in a time that does not depend on whether, or where, the two differ.
bool sameToken(std::string_view given, std::string_view right);

}  // namespace aeolic::stream
