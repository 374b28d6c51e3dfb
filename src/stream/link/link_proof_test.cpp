#include "stream/link/link_greeting.h"

#include <gtest/gtest.h>

#include <set>

#include "stream/token.h"

namespace aeolic::stream {
namespace {

TEST(LinkProof, IsAnHmac)
{
    // printf 'aeolic rank %032d%032dx' 1 2 | openssl dgst -sha256 -hmac secret
    std::string one(32, '0'), two(32, '0');
    one.back() = '1', two.back() = '2';
    EXPECT_EQ(linkProof("secret", LinkEnd::rank, one, two, "x"),
              "1c12cc0c26bb984c1f012a615f9bcdfa45f492e9f9684b06c64d86f63bf394ae");
}

TEST(LinkProof, DependsOnAllThatItProves)
{
    const std::string gateway = makeToken(), rank = makeToken();
    std::set<std::string> proofs;
    for (const std::string secret : {"secret", "Secret", ""})
        for (const LinkEnd end : {LinkEnd::gateway, LinkEnd::rank})
            for (const auto& [a, b] : {std::pair(gateway, rank), std::pair(rank, gateway)})
                for (const std::string claim : {"", "rank 0", "rank 1"})
                    EXPECT_TRUE(proofs.insert(linkProof(secret, end, a, b, claim)).second);
    EXPECT_EQ(proofs.begin()->size(), 64u);
}

TEST(LinkProof, NoncesAreOfOneLength)
{
    EXPECT_TRUE(isNonce(makeToken()));
    for (const std::string& wrong : {std::string(), std::string(31, 'x'), std::string(33, 'x'), std::string(32, ' '),
                                     std::string(32, '\0'), std::string(32, '\xff')})
        EXPECT_FALSE(isNonce(wrong));
}

}  // namespace
}  // namespace aeolic::stream
