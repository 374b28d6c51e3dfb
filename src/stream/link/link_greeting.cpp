#include "stream/link/link_greeting.h"

#include "stream/link/link_proof.h"
#include "stream/token.h"

namespace aeolic::stream {
namespace {

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

void require(bool isRight)
{
    if (!isRight) throw ProtocolError("the other end does not know the secret");
}

}  // namespace

asio::awaitable<Json> greetRank(LinkSocket& link, std::string secret)
{
    const ByteVector knock = co_await link.readMessage(Sender::rank, MessageType::knock);
    const std::string rankNonce = nonceOf(parseJson(ByteView(knock).subspan(kHeaderBytes)));
    const std::string nonce = makeToken();
    const Json challenge{{"nonce", nonce}, {"proof", linkProof(secret, LinkEnd::gateway, nonce, rankNonce)}};
    const WireMessage message = jsonMessage(MessageType::challenge, challenge.dump());
    co_await link.write(*message);
    const ByteVector join = co_await link.readMessage(Sender::rank, MessageType::join);
    Json about = parseJson(ByteView(join).subspan(kHeaderBytes));
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
    const ByteVector message = co_await link.readMessage(Sender::gatewayToRank, MessageType::challenge);
    const Json challenge = parseJson(ByteView(message).subspan(kHeaderBytes));
    const std::string gatewayNonce = nonceOf(challenge);
    require(sameToken(textOf(challenge, "proof"), linkProof(secret, LinkEnd::gateway, gatewayNonce, nonce)));
    const std::string proof = linkProof(secret, LinkEnd::rank, gatewayNonce, nonce, about.dump());
    about["proof"] = proof;
    const WireMessage join = jsonMessage(MessageType::join, about.dump());
    co_await link.write(*join);
}

}  // namespace aeolic::stream
