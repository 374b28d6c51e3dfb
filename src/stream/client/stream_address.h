#pragma once

#include <string>

namespace aeolic::stream {

struct StreamAddress {
    std::string host, port, token;
    bool secure = false;
};

/// Reads "http://host:port/?token=T". Scheme and path may be left out. Throws InputError.
StreamAddress parseStreamAddress(const std::string& address);

}  // namespace aeolic::stream
