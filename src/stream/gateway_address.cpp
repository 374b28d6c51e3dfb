#include "stream/gateway_address.h"

#include <algorithm>

#include "stream/requests.h"

namespace aeolic::stream {

std::string addressToJson(const GatewayAddress& address)
{
    return Json{{"hosts", address.hosts},           {"port", address.port},
                {"secret", address.secret},         {"direct", address.direct},
                {"everywhere", address.everywhere}, {"silenceLimitS", address.silenceLimitS}}
        .dump();
}

GatewayAddress addressFromJson(const std::string& json)
{
    const Json document = parseJson(json);
    try {
        return {document.at("hosts").get<std::vector<std::string>>(),
                document.at("port").get<std::uint16_t>(),
                document.at("secret").get<std::string>(),
                document.at("direct").get<bool>(),
                document.at("everywhere").get<bool>(),
                std::max(1, document.at("silenceLimitS").get<int>())};
    } catch (const Json::exception&) {
        throw ProtocolError("standard input does not tell where the gateway is");
    }
}

}  // namespace aeolic::stream
