#include "stream/token.h"

#include <openssl/crypto.h>
#include <openssl/rand.h>

#include <array>
#include <stdexcept>

#include "aeolic/error.h"

namespace aeolic::stream {
namespace {

/// The first 64 are those of new tokens.
constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.";

}  // namespace

std::string makeToken()
{
    std::array<unsigned char, 32> random;
    if (RAND_bytes(random.data(), int(random.size())) != 1)
        throw std::runtime_error("the system gives no random numbers for a token");
    std::string token;
    for (const unsigned char byte : random) token += kPlain[byte & 63];
    return token;
}

void checkToken(const std::string& where, const std::string& token)
{
    if (token.find_first_not_of(kPlain) != token.npos)
        throw InputError(where, "found a character that an address cannot hold as it is", "letters, digits, - _ .");
    if (token.size() < kShortestToken || token.size() > kLongestToken)
        throw InputError(where, "found " + std::to_string(token.size()) + " characters",
                         std::to_string(kShortestToken) + " to " + std::to_string(kLongestToken));
}

bool sameToken(std::string_view given, std::string_view right)
{
    return given.size() == right.size() && CRYPTO_memcmp(given.data(), right.data(), right.size()) == 0;
}

}  // namespace aeolic::stream
