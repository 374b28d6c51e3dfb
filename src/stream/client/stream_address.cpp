#include "stream/client/stream_address.h"

#include <algorithm>
#include <cstdint>

#include "aeolic/error.h"
#include "base/text.h"

namespace aeolic::stream {
namespace {

[[noreturn]] void refuse(const std::string& address)
{
    throw InputError("address", "found '" + address + "'", "http://HOST:PORT/?token=TOKEN as the server printed it");
}

}  // namespace

StreamAddress parseStreamAddress(const std::string& address)
{
    if (std::any_of(address.begin(), address.end(), [](char c) { return c == ' ' || isControl(c); })) refuse(address);
    StreamAddress result;
    std::string rest = address;
    if (const std::size_t scheme = rest.find("://"); scheme != rest.npos) {
        const std::string name = rest.substr(0, scheme);
        if (name != "http" && name != "https") refuse(address);
        result.secure = name == "https";
        rest.erase(0, scheme + 3);
    }
    const std::size_t end = rest.find_first_of("/?#");
    std::string authority = rest.substr(0, end), query = end == rest.npos ? "" : rest.substr(end);
    const std::size_t bracket = authority.rfind(']'), colon = authority.rfind(':');
    const bool hasPort = colon != authority.npos && (bracket == authority.npos || colon > bracket);
    result.host = authority.substr(0, hasPort ? colon : authority.npos);
    result.port = hasPort ? authority.substr(colon + 1) : result.secure ? "443" : "80";
    if (result.host.size() >= 2 && result.host.front() == '[')
        result.host = result.host.substr(1, result.host.size() - 2);
    const bool isPort = result.port.size() <= 5 && wholeTextAs<std::uint16_t>(result.port);
    if (result.host.empty() || !isPort) refuse(address);
    query = query.substr(0, query.find('#'));
    for (const char* mark : {"?token=", "&token="})
        if (const std::size_t at = query.find(mark); at != query.npos)
            result.token = query.substr(at + 7, query.find('&', at + 7) - (at + 7));
    return result;
}

}  // namespace aeolic::stream
