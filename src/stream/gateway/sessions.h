#pragma once

#include <list>
#include <string>
#include <string_view>

#include "stream/token.h"

namespace aeolic::stream {

/// The browsers that have brought the token. Each has an id of its own instead, which is its cookie: browsers show a
/// cookie to every port of the host, and the token is not for them. Ids end with the server. Not thread-safe.
class Sessions {
public:
    static constexpr std::size_t kMost = 256;  ///< As many as there can be viewers.

    /// A new id, of 192 random bits. If there are kMost, the one that was used least recently is forgotten.
    std::string open()
    {
        if (ids_.size() >= kMost) ids_.pop_back();
        ids_.push_front(makeToken());
        return ids_.front();
    }
    /// Whether the id is one of these; if so, it has been used now. Takes equally long for every wrong id of a length.
    bool knows(std::string_view id)
    {
        auto found = ids_.end();
        for (auto one = ids_.begin(); one != ids_.end(); ++one)
            if (sameToken(id, *one)) found = one;
        if (found == ids_.end()) return false;
        ids_.splice(ids_.begin(), ids_, found);
        return true;
    }
    std::size_t count() const { return ids_.size(); }

private:
    std::list<std::string> ids_;  ///< The one used most recently first.
};

}  // namespace aeolic::stream
