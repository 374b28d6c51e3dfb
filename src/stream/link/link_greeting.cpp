#include "stream/link/link_greeting.h"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "stream/token.h"

namespace aeolic::stream {
namespace {

constexpr std::size_t kNonceCharacters = 32;

std::string textOf(const Json& json, const char* key)
{
    const auto found = json.find(key);
    if (found == json.end() || !found->is_string()) throw ProtocolError(std::string("no ") + key);
    return found->get<std::string>();
}

std::string nonceOf(const Json& json)
{
    std::string nonce = textOf(json, "nonce");
    if (!isNonce(nonce)) throw ProtocolError("a nonce of another length");
    return nonce;
}

asio::awaitable<Json> readJson(LinkSocket& link, Sender sender, MessageType type)
{
    const WireMessage message = co_await link.readMessage(sender, type);
    co_return parseJson(ByteView(*message).subspan(kHeaderBytes));
}

void require(bool isRight)
{
    if (!isRight) throw ProtocolError("the other end does not know the secret");
}

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
    return fmt::format("{:02x}", fmt::join(digest.begin(), digest.begin() + bytes, ""));
}

bool isNonce(std::string_view text)
{
    return text.size() == kNonceCharacters &&
           std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < 127; });
}

asio::awaitable<Json> greetRank(LinkSocket& link, std::string secret)
{
    const Json knock = co_await readJson(link, Sender::rank, MessageType::knock);
    const std::string rankNonce = nonceOf(knock);
    const std::string nonce = makeToken();
    const Json challenge{{"nonce", nonce}, {"proof", linkProof(secret, LinkEnd::gateway, nonce, rankNonce)}};
    const WireMessage message = jsonMessage(MessageType::challenge, challenge.dump());
    co_await link.write(*message);
    Json about = co_await readJson(link, Sender::rank, MessageType::join);
    const std::string proof = textOf(about, "proof");
    about.erase("proof");
    require(!secret.empty() && sameToken(proof, linkProof(secret, LinkEnd::rank, nonce, rankNonce, about.dump())));
    co_return about;
}

asio::awaitable<void> greetGateway(LinkSocket& link, std::string secret, Json about)
{
    const std::string nonce = makeToken();
    const WireMessage knock = jsonMessage(MessageType::knock, Json{{"nonce", nonce}}.dump());
    co_await link.write(*knock);
    const Json challenge = co_await readJson(link, Sender::gatewayToRank, MessageType::challenge);
    const std::string gatewayNonce = nonceOf(challenge);
    require(sameToken(textOf(challenge, "proof"), linkProof(secret, LinkEnd::gateway, gatewayNonce, nonce)));
    const std::string proof = linkProof(secret, LinkEnd::rank, gatewayNonce, nonce, about.dump());
    about["proof"] = proof;
    const WireMessage join = jsonMessage(MessageType::join, about.dump());
    co_await link.write(*join);
}

}  // namespace aeolic::stream
