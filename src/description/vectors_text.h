#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace aeolic {

/// What is between `before` and a bracket at the end; nothing where the text is of another form.
inline std::optional<std::string> insideBrackets(const std::string& text, std::string_view before)
{
    if (!text.starts_with(before) || !text.ends_with(')')) return {};
    return text.substr(before.size(), text.size() - before.size() - 1);
}

/// The parts of a `FieldSource::vectors` where there is a field: NAME or wallShear(NAME).
struct FieldVectors {
    std::string name;    ///< The array's.
    bool shear = false;  ///< Its wall shear is wanted.
};

inline FieldVectors parseFieldVectors(const std::string& text)
{
    if (auto name = insideBrackets(text, "wallShear(")) return {std::move(*name), true};
    return {text, false};
}

/// The parts of the vectors that a surface has itself: NAME or reversed(NAME).
struct SurfaceVectors {
    std::string name;       ///< The array's; empty: the usual one.
    bool reversed = false;  ///< They are turned round.
};

inline SurfaceVectors parseSurfaceVectors(const std::string& text)
{
    if (auto name = insideBrackets(text, "reversed(")) return {std::move(*name), true};
    return {text, false};
}

inline std::string reversedName(const std::string& name)
{
    return "reversed(" + name + ")";
}

}  // namespace aeolic
