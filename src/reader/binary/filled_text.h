#pragma once

#include <algorithm>
#include <string>

#include "base/text.h"

namespace aeolic {

/// A text as a file of fixed lengths has it, without what fills it up: up to its first zero, without spaces behind it.
inline std::string withoutFilling(std::string text)
{
    text.erase(std::min(text.find('\0'), text.size()));
    while (!text.empty() && (text.back() == ' ' || text.back() == '\n')) text.pop_back();
    return withoutControls(std::move(text), '?');
}

}  // namespace aeolic
