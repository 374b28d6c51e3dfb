#pragma once

#include <string>

namespace aeolic {

/// The program that reads files of data. The environment variable AEOLIC_READER names it; else it is looked for beside
/// the library: in its folder, in libexec/aeolic there, and in libexec/aeolic of the folder that the library's was
/// installed in. Throws InputError where it is not there.
std::string readerProgram();

}  // namespace aeolic
