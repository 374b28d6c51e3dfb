#include "stream/client/stream_address.h"

#include <gtest/gtest.h>

#include "aeolic/error.h"

namespace aeolic::stream {
namespace {

TEST(StreamAddress, AsTheServerPrintsIt)
{
    const StreamAddress plain = parseStreamAddress("http://127.0.0.1:8080/?token=aB3-_");
    EXPECT_EQ(plain.host, "127.0.0.1");
    EXPECT_EQ(plain.port, "8080");
    EXPECT_EQ(plain.token, "aB3-_");
    EXPECT_FALSE(plain.secure);
    const StreamAddress secure = parseStreamAddress("https://[::1]:8443/?token=x#view");
    EXPECT_EQ(secure.host, "::1");
    EXPECT_EQ(secure.port, "8443");
    EXPECT_EQ(secure.token, "x");
    EXPECT_TRUE(secure.secure);
}

TEST(StreamAddress, WhatIsLeftOutIsFilledIn)
{
    EXPECT_EQ(parseStreamAddress("localhost:9000").port, "9000");
    EXPECT_EQ(parseStreamAddress("localhost").port, "80");
    EXPECT_EQ(parseStreamAddress("https://localhost/").port, "443");
    EXPECT_EQ(parseStreamAddress("https://[fe80::1]").host, "fe80::1");
    EXPECT_EQ(parseStreamAddress("http://host:1/").token, "");
    EXPECT_EQ(parseStreamAddress("host:1?a=b&token=t&c=d").token, "t");
    EXPECT_EQ(parseStreamAddress("http://host:1/#token=t").token, "") << "what follows # is the page's";
    EXPECT_EQ(parseStreamAddress("http://host:1/?nottoken=a&token=t").token, "t");
}

TEST(StreamAddress, WhatIsNoAddressIsRefused)
{
    for (const char* wrong : {"", "http://", "ftp://host:1/", "ws://host:1/", "host:", "host:x", "host:123456", ":80",
                              "http:///?token=x", "http://host:-1/", "http://host:65536/", "http://[]:80/"})
        EXPECT_THROW(parseStreamAddress(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace aeolic::stream
