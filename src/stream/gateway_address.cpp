#include "stream/gateway_address.h"

#include <algorithm>

#include "stream/requests.h"

namespace aeolic::stream {

std::string addressToJson(const GatewayAddress& address)
{
    return Json{{"hosts", address.hosts},
                {"port", address.port},
                {"secret", address.secret},
                {"fingerprint", address.fingerprint},
                {"direct", address.direct},
                {"everywhere", address.everywhere},
                {"directPorts", {address.directPorts.first, address.directPorts.last}},
                {"silenceLimitS", address.silenceLimitS},
                {"directBytes", address.directBytes}}
        .dump();
}

GatewayAddress addressFromJson(const std::string& json)
{
    const Json document = parseJson(json);
    try {
        const Json& ports = document.at("directPorts");
        return {document.at("hosts").get<std::vector<std::string>>(),
                document.at("port").get<std::uint16_t>(),
                document.at("secret").get<std::string>(),
                document.at("fingerprint").get<std::string>(),
                document.at("direct").get<bool>(),
                document.at("everywhere").get<bool>(),
                {ports.at(0).get<std::uint16_t>(), ports.at(1).get<std::uint16_t>()},
                std::max(1, document.at("silenceLimitS").get<int>()),
                document.at("directBytes").get<std::uint64_t>()};
    } catch (const Json::exception&) {
        throw ProtocolError("standard input does not tell where the gateway is");
    }
}

}  // namespace aeolic::stream
