#pragma once

namespace aeolic {

/// Puts one list's values behind another's.
template <class List, class More>
void appendAll(List& list, const More& more)
{
    list.insert(list.end(), more.begin(), more.end());
}

}  // namespace aeolic
