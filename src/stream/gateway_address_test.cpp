#include "stream/gateway_address.h"

#include <gtest/gtest.h>

#include "stream/wire.h"

namespace aeolic::stream {
namespace {

TEST(GatewayAddresses, AreReadAsTheyAreWritten)
{
    const GatewayAddress address{{"node7", "127.0.0.1"}, 41237, "a secret", "ab01", true, false, {5000, 5009}, 7,
                                 std::uint64_t{5} << 32};
    const std::string line = addressToJson(address);
    EXPECT_EQ(line.find('\n'), line.npos) << "one line";
    EXPECT_EQ(addressFromJson(line), address);
}

TEST(GatewayAddresses, AnythingElseIsRefused)
{
    for (const char* bad : {"", "x", "[]", "{}", R"({"hosts":["a"],"port":1,"secret":"s","direct":true})",
                            R"({"hosts":"a","port":1,"secret":"s","direct":true,"everywhere":true})"})
        EXPECT_THROW(addressFromJson(bad), ProtocolError) << bad;
}

}  // namespace
}  // namespace aeolic::stream
