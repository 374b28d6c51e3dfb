#include "stream/gateway/sessions.h"

#include <iterator>

#include "stream/token.h"

namespace aeolic::stream {

std::string Sessions::open()
{
    if (ids_.size() >= kMost) ids_.pop_back();
    ids_.push_front(makeToken());
    return ids_.front();
}

bool Sessions::knows(std::string_view id)
{
    auto found = ids_.end();
    for (auto one = ids_.begin(); one != ids_.end(); ++one)
        if (sameToken(id, *one)) found = one;
    if (found == ids_.end()) return false;
    ids_.splice(ids_.begin(), ids_, found);
    return true;
}

}  // namespace aeolic::stream
