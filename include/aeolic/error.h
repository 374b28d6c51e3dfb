#pragma once

#include <stdexcept>
#include <string>

namespace aeolic {

/// The user's input was wrong: one line that names the file or option, the item, what was found and what was expected.
/// The command line prints it and exits with 2.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    InputError(const std::string& where, const std::string& found, const std::string& expected)
        : std::runtime_error(where + ": " + found + "; expected " + expected)
    {
    }
};

}  // namespace aeolic
