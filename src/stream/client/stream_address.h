#pragma once

#include <string>

namespace aeolic::stream {

struct StreamAddress {
    std::string host, port, token;
    bool secure = false;
};

/// "http://host:port/?token=T", the scheme and path left out or not. Throws InputError.
StreamAddress parseStreamAddress(const std::string& address);

}  // namespace aeolic::stream
