#include "stream/token.h"

#include <openssl/crypto.h>
#include <openssl/rand.h>

#include <array>
#include <stdexcept>

namespace aeolic::stream {

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

bool sameToken(std::string_view given, std::string_view right)
{
    return given.size() == right.size() && CRYPTO_memcmp(given.data(), right.data(), right.size()) == 0;
}

}  // namespace aeolic::stream
