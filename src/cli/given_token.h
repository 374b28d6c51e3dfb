#pragma once

#include <string>

namespace aeolic {

/// Throws InputError, which names `where`, for a token that is easy to guess (fewer than 16 characters), longer than
/// 256, or that an address cannot hold as it is. The line never holds the token.
void checkToken(const std::string& where, const std::string& token);

/// The token that a file holds, in one line. Throws InputError where it cannot be read, holds anything else, or is a
/// file that others than its owner may read.
std::string tokenFromFile(const std::string& path);

/// The token of the environment variable AEOLIC_TOKEN; empty where it is not set. The variable is taken out of this
/// process's environment, so that no program that it starts gets it. Throws InputError as checkToken() does.
std::string tokenFromEnvironment();

}  // namespace aeolic
