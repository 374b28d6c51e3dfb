#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace aeolic {

/// The end of a message about a name that is not known: "; did you mean --color-by?", or nothing where none of `names`
/// is near. Case, '-' and '_' count for nothing. For three letters of the shorter name one fault is forgiven: a letter
/// too many, too few, another one, or two that changed places. Of several that are equally near, the first that begins
/// with `typed`, else the first.
std::string didYouMean(std::string_view typed, const std::vector<std::string_view>& names);

/// For lists of other types.
template <class Names>
std::string didYouMean(std::string_view typed, const Names& names)
{
    return didYouMean(typed, std::vector<std::string_view>(std::begin(names), std::end(names)));
}

}  // namespace aeolic
