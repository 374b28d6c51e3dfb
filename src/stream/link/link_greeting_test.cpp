#include "stream/link/link_greeting.h"

#include <gtest/gtest.h>

#include <boost/asio/connect.hpp>
#include <functional>

#include "stream/token.h"

namespace aeolic::stream {
namespace {

const Json kAbout{{"rank", 2}, {"ranks", 8}, {"host", "node7"}, {"pid", 4711}, {"direct", nullptr}};

/// Two ends of a connection and what they do at the same time.
class Greetings : public testing::Test {
protected:
    using Part = std::function<asio::awaitable<void>(LinkSocket&)>;

    Greetings() { connect(); }
    void connect()
    {
        rank_ = LinkSocket(Tcp::socket(io_));
        Tcp::acceptor acceptor(io_, {asio::ip::address_v4::loopback(), 0});
        rank_.tcp().connect(acceptor.local_endpoint());
        gateway_ = LinkSocket(acceptor.accept());
    }
    /// Whether both came to their end. Who fails hangs up.
    bool meet(const Part& gateway, const Part& rank)
    {
        int whole = 0;
        const auto play = [&](LinkSocket& link, const Part& part) {
            asio::co_spawn(io_, part(link), [&](const std::exception_ptr& failure) {
                whole += !failure;
                if (failure) link.close();
            });
        };
        play(gateway_, gateway);
        play(rank_, rank);
        io_.restart();
        io_.run_for(std::chrono::seconds(20));
        return whole == 2;
    }
    static Part gatewayWith(const std::string& secret, Json& got)
    {
        return [secret, &got](LinkSocket& link) -> asio::awaitable<void> { got = co_await greetRank(link, secret); };
    }
    static Part rankWith(const std::string& secret, Json about = kAbout)
    {
        return [secret, about](LinkSocket& link) -> asio::awaitable<void> { return greetGateway(link, secret, about); };
    }

    asio::io_context io_;
    LinkSocket rank_{Tcp::socket(io_)}, gateway_{Tcp::socket(io_)};
    Json told_;
};

TEST_F(Greetings, WhoKnowTheSecretMeet)
{
    EXPECT_TRUE(meet(gatewayWith("secret", told_), rankWith("secret")));
    EXPECT_EQ(told_, kAbout);
}

TEST_F(Greetings, AStrangerIsNoRank)
{
    EXPECT_FALSE(meet(gatewayWith("secret", told_), rankWith("other")));
    EXPECT_TRUE(told_.is_null());
}

TEST_F(Greetings, WithoutASecretNobodyIsLetIn)
{
    EXPECT_FALSE(meet(gatewayWith("", told_), rankWith("")));
    EXPECT_TRUE(told_.is_null());
}

/// An impostor who answers first: it gets a number drawn at random, and no more.
TEST_F(Greetings, ARankTellsAnImpostorNothing)
{
    WireMessage heard;
    const auto impostor = [&](LinkSocket& link) -> asio::awaitable<void> {
        heard = co_await link.readMessage(Sender::rank, MessageType::knock);
        const Json challenge{{"nonce", makeToken()}, {"proof", linkProof("guess", LinkEnd::gateway, "a", "b")}};
        const WireMessage message = jsonMessage(MessageType::challenge, challenge.dump());
        co_await link.write(*message);
        heard = co_await link.readMessage(Sender::rank, MessageType::join);
    };
    EXPECT_FALSE(meet(impostor, rankWith("the-secret-of-this-start")));
    const std::string text(heard->begin(), heard->end());
    EXPECT_EQ(text.find("secret"), text.npos);
    EXPECT_EQ(text.find("node7"), text.npos);
    EXPECT_EQ(parseJson(ByteView(*heard).subspan(kHeaderBytes)).size(), 1u) << text;
}

/// One that sends the rank's own proof back, or the gateway's, proves nothing.
TEST_F(Greetings, ProofsCannotBeSentBack)
{
    const auto mirror = [](LinkSocket& link) -> asio::awaitable<void> {
        const std::string nonce = makeToken();
        const WireMessage knock = jsonMessage(MessageType::knock, Json{{"nonce", nonce}}.dump());
        co_await link.write(*knock);
        const WireMessage message = co_await link.readMessage(Sender::gatewayToRank, MessageType::challenge);
        Json join = kAbout;
        join["proof"] = parseJson(ByteView(*message).subspan(kHeaderBytes))["proof"];
        const WireMessage answer = jsonMessage(MessageType::join, join.dump());
        co_await link.write(*answer);
    };
    EXPECT_FALSE(meet(gatewayWith("secret", told_), mirror));
    EXPECT_TRUE(told_.is_null());
}

TEST_F(Greetings, WhatARankSaysAboutItselfCannotBeChangedOnTheWay)
{
    const auto liar = [](LinkSocket& link) -> asio::awaitable<void> {
        const std::string nonce = makeToken();
        const WireMessage knock = jsonMessage(MessageType::knock, Json{{"nonce", nonce}}.dump());
        co_await link.write(*knock);
        const WireMessage message = co_await link.readMessage(Sender::gatewayToRank, MessageType::challenge);
        const std::string other = parseJson(ByteView(*message).subspan(kHeaderBytes))["nonce"];
        Json join = kAbout;
        const std::string proof = linkProof("secret", LinkEnd::rank, other, nonce, join.dump());
        join["rank"] = 3;
        join["proof"] = proof;
        const WireMessage answer = jsonMessage(MessageType::join, join.dump());
        co_await link.write(*answer);
    };
    EXPECT_FALSE(meet(gatewayWith("secret", told_), liar));
    EXPECT_TRUE(told_.is_null());
}

TEST_F(Greetings, Nonsense)
{
    for (const char* knock : {"{}", R"({"nonce":7})", R"({"nonce":"short"})", "[]", "{", R"({"nonce":null})"}) {
        SCOPED_TRACE(knock);
        const Part stranger = [knock](LinkSocket& link) -> asio::awaitable<void> {
            const WireMessage message = jsonMessage(MessageType::knock, knock);
            co_await link.write(*message);
            const WireMessage answer = co_await link.readMessage(Sender::gatewayToRank, MessageType::challenge);
        };
        connect();
        EXPECT_FALSE(meet(gatewayWith("secret", told_), stranger));
        EXPECT_TRUE(told_.is_null());
    }
}

TEST_F(Greetings, EncryptedEndsMeetWhereTheCertificateIsTheRightOne)
{
    std::string fingerprint;
    const TlsSide server = makeTlsServer(fingerprint), client = makeTlsClient(fingerprint);
    EXPECT_EQ(fingerprint.size(), 64u);
    const ByteVector much(3'000'000, 7);
    ByteVector got(much.size());
    const auto gateway = [&](LinkSocket& link) -> asio::awaitable<void> {
        co_await link.startTls(server, true);
        told_ = co_await greetRank(link, "secret");
        co_await link.write(much);
    };
    const auto rank = [&](LinkSocket& link) -> asio::awaitable<void> {
        co_await link.startTls(client, false);
        co_await greetGateway(link, "secret", kAbout);
        co_await link.read(got.data(), got.size());
    };
    EXPECT_TRUE(meet(gateway, rank));
    EXPECT_EQ(told_, kAbout);
    EXPECT_EQ(got, much);
}

TEST_F(Greetings, AnotherCertificateIsAnImpostors)
{
    std::string fingerprint, other;
    const TlsSide right = makeTlsServer(fingerprint), impostor = makeTlsServer(other);
    EXPECT_NE(fingerprint, other);
    bool reached = false;
    EXPECT_FALSE(meet([&](LinkSocket& link) { return link.startTls(impostor, true); },
                      [&](LinkSocket& link) -> asio::awaitable<void> {
                          co_await link.startTls(makeTlsClient(fingerprint), false);
                          reached = true;
                      }));
    EXPECT_FALSE(reached);
}

TEST_F(Greetings, PlainTextIsNoTls)
{
    std::string fingerprint;
    const TlsSide server = makeTlsServer(fingerprint);
    EXPECT_FALSE(meet([&](LinkSocket& link) { return link.startTls(server, true); }, rankWith("secret")));
}

}  // namespace
}  // namespace aeolic::stream
