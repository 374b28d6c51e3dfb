#include "description/scene_fields.h"

#include <algorithm>
#include <string>

#include "render/colormap.h"

namespace aeolic::fields {

bool isBackground(std::string_view text)
{
    const auto isHexDigit = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    };
    return text == "transparent" || (text.size() == 6 && std::all_of(text.begin(), text.end(), isHexDigit));
}

bool isColorMap(std::string_view text)
{
    const auto names = colorMapNames();
    return std::find(names.begin(), names.end(), text) != names.end();
}

bool isPrecision(std::string_view text)
{
    return text == "float" || text == "half";
}

bool isBackend(std::string_view text)
{
    return text == "auto" || text == "cpu" || text == "gl";
}

bool isBalance(std::string_view text)
{
    return text == "static" || text == "timing" || text == "pixels" || text == "hybrid";
}

bool isBricks(std::string_view text)
{
    return text == "on" || text == "off" || text == "auto";
}

bool isGuard(std::string_view text)
{
    return text == "bound" || text == "estimate";
}

bool isGuardRows(std::string_view text)
{
    return text == "project" || text == "receive" || text == "auto";
}

const char* expectedColorMap()
{
    static const std::string expected = [] {
        std::string text = "one of";
        for (const std::string& name : colorMapNames()) text += (text == "one of" ? " " : ", ") + name;
        return text;
    }();
    return expected.c_str();
}

}  // namespace aeolic::fields
