#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// The text of a help in lines that stay beside CLI11's column of names. Its own line breaks stay.
std::string wrapped(const std::string& text);

/// Adds a word that has to be typed, and that stands before the scene file: it is added before SceneOptions.
std::shared_ptr<std::string> addFirstWord(CLI::App& command, const std::string& name, const std::string& help);

/// The options that describe a scene, for every command that draws one: an optional scene file, and options that
/// override it.
class SceneOptions {
public:
    /// Adds the options to `command`. This object must outlive the parsing.
    explicit SceneOptions(CLI::App& command);

    /// The scene asked for, complete and valid. Call after parsing. Throws InputError naming the option or the file's
    /// field.
    SceneDescription scene() const;

    /// The text of each option that was typed, but for those that may be given several times.
    const std::map<std::string, std::string>& given() const { return given_; }

private:
    void refuseOptionsAsValues() const;

    const CLI::App& command_;
    std::optional<std::string> sceneFile_;
    std::map<std::string, std::string> given_;
    std::map<std::string, std::vector<std::string>>
        repeated_;  ///< The texts of options that may be given several times.
};

}  // namespace aeolic
