#pragma once

#include <string>

namespace aeolic {

/// The folder that relative names of files are in now, so that they can be found when the process has gone to another
/// one. It goes in front of names. A text from which it is taken out again has the names as they were.
class StartFolder {
public:
    /// Where the folder is gone, names stay as they are.
    StartFolder();

    /// The name, if it is relative with the folder in front.
    std::string absolute(const std::string& path) const;

    /// A message with the names as the user gave them.
    std::string asGiven(std::string message) const;

    bool operator==(const StartFolder&) const = default;

private:
    std::string prefix_;  // "/home/of/somebody/./": the dot tells it from what the user typed.
};

}  // namespace aeolic
