#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "stream/listen.h"

namespace aeolic::stream {

/// Where a rank finds its gateway. It is one line of JSON on rank 0's standard input.
struct GatewayAddress {
    std::vector<std::string> hosts;  ///< Hosts, tried in this order.
    std::uint16_t port = 0;
    std::string secret;
    std::string fingerprint;  ///< Of the gateway's certificate (makeTlsServer()). Empty: the links are not encrypted.
    bool direct = false;      ///< Ranks listen for viewers.
    bool everywhere = false;  ///< Ranks listen for viewers on all interfaces.
    PortRange directPorts;    ///< Where they listen.
    int silenceLimitS = int(kSilenceLimit.count());  ///< Seconds after which a silent gateway counts as gone.
    std::uint64_t directBytes = std::uint64_t(-1);   ///< What tiles that wait for viewers may take in this rank.
    bool operator==(const GatewayAddress&) const = default;
};
std::string addressToJson(const GatewayAddress& address);
/// Throws ProtocolError.
GatewayAddress addressFromJson(const std::string& json);

}  // namespace aeolic::stream
