#include "stream/link/link_proof.h"

#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "stream/hex.h"

namespace aeolic::stream {
namespace {

constexpr std::size_t kNonceCharacters = 32;

}  // namespace

std::string linkProof(std::string_view secret, LinkEnd end, std::string_view gatewayNonce, std::string_view rankNonce,
                      std::string_view claim)
{
    // Nonces are of one length and the claim comes last, so no two different inputs give the same text.
    std::string text = end == LinkEnd::gateway ? "aeolic gateway " : "aeolic rank ";
    text.append(gatewayNonce).append(rankNonce).append(claim);
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned bytes = 0;
    if (!HMAC(EVP_sha256(), secret.data(), int(secret.size()), reinterpret_cast<const unsigned char*>(text.data()),
              text.size(), digest.data(), &bytes))
        throw std::runtime_error("OpenSSL makes no HMAC");
    return hexText({digest.data(), bytes});
}

bool isNonce(std::string_view text)
{
    return text.size() == kNonceCharacters &&
           std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < 127; });
}

}  // namespace aeolic::stream
