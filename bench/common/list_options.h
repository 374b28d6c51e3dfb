#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace aeolic {

/// "a,b,c" to its items; an empty text is one empty item.
std::vector<std::string> listItems(const std::string& text);

/// The whole of `text` as a whole number. Throws InputError naming `option` where it is none from `least` to `most`.
int wholeNumber(const std::string& option, std::string_view text, double least, double most);

/// Every item of a list as `parse` reads it.
template <class Parse>
auto parseList(const std::string& text, const Parse& parse)
{
    std::vector<decltype(parse(text))> values;
    for (const std::string& item : listItems(text)) values.push_back(parse(item));
    return values;
}

}  // namespace aeolic
