#pragma once

#include <string>
#include <string_view>

namespace aeolic::stream {

/// 192 random bits, as 32 characters that need no escaping in a URL. Throws std::runtime_error where the system has no
/// random numbers.
std::string makeToken();

inline constexpr std::size_t kShortestToken = 16, kLongestToken = 256;

/// Throws InputError, which names `where`, for a token that is easy to guess (fewer than 16 characters), longer than
/// 256, or that an address cannot hold as it is. The line never holds the token.
void checkToken(const std::string& where, const std::string& token);

/// Compares in a time that does not depend on whether, or where, the two differ.
bool sameToken(std::string_view given, std::string_view right);

}  // namespace aeolic::stream
