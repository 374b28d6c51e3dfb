#pragma once

namespace aeolic {

/// Appends the values of `more` to `list`.
template <class List, class More>
void appendAll(List& list, const More& more)
{
    list.insert(list.end(), more.begin(), more.end());
}

}  // namespace aeolic
