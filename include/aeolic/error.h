#pragma once

#include <stdexcept>
#include <string>

namespace aeolic {

/// The user's input was wrong: one line that names the file or option, the item, what was found and what was expected.
/// Control characters, which names in files may hold, are spaces in it. The command line prints it and exits with 2.
class InputError : public std::runtime_error {
public:
    explicit InputError(const std::string& message);
    InputError(const std::string& where, const std::string& found, const std::string& expected)
        : InputError(where + ": " + found + "; expected " + expected)
    {
    }
};

}  // namespace aeolic
