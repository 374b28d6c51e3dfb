#pragma once

#include <string>
#include <string_view>

namespace aeolic {

/// The parts of a `FieldSource::vectors` where there is a field: NAME or wallShear(NAME).
struct FieldVectors {
    std::string name;    ///< The array's.
    bool shear = false;  ///< Its wall shear is wanted.
};

inline FieldVectors parseFieldVectors(const std::string& text)
{
    constexpr std::string_view before = "wallShear(";
    if (!text.starts_with(before) || !text.ends_with(')')) return {text, false};
    return {text.substr(before.size(), text.size() - before.size() - 1), true};
}

}  // namespace aeolic
