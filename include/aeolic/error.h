#pragma once

#include <stdexcept>
#include <string>

namespace aeolic {

/// The user's input was wrong: one line that names the file or option, the item, what was found and what was expected.
/// Control characters, which names in files may hold, are spaces in it. The command line prints it and exits with 2.
class InputError : public std::runtime_error {
public:
    explicit InputError(const std::string& message) : std::runtime_error(oneLine(message)) {}
    InputError(const std::string& where, const std::string& found, const std::string& expected)
        : InputError(where + ": " + found + "; expected " + expected)
    {
    }

private:
    static std::string oneLine(std::string text)
    {
        for (char& c : text)
            if (static_cast<unsigned char>(c) < ' ' || c == 127) c = ' ';
        return text;
    }
};

}  // namespace aeolic
