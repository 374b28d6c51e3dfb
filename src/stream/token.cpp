#include "stream/token.h"

#include <openssl/crypto.h>
#include <openssl/rand.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "aeolic/error.h"

namespace aeolic::stream {
namespace {

bool isPlain(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_' ||
           c == '.';
}

}  // namespace

std::string makeToken()
{
    constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    std::array<unsigned char, 32> random;
    if (RAND_bytes(random.data(), int(random.size())) != 1)
        throw std::runtime_error("the system gives no random numbers for a token");
    std::string token;
    for (const unsigned char byte : random) token += alphabet[byte & 63];
    return token;
}

void checkToken(const std::string& where, const std::string& token)
{
    if (!std::all_of(token.begin(), token.end(), isPlain))
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
