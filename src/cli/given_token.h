#pragma once

#include <string>

namespace aeolic {

/// The token that a file holds, in one line. Throws InputError where it cannot be read, holds anything else, or is a
/// file that others than its owner may read.
std::string tokenFromFile(const std::string& path);

/// The token of the environment variable AEOLIC_TOKEN; empty where it is not set. The variable is taken out of this
/// process's environment, so that no program that it starts gets it. Throws InputError as stream::checkToken() does.
std::string tokenFromEnvironment();

}  // namespace aeolic
