#include "stream/gateway/job_links.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "aeolic/error.h"
#include "stream/job/job_link.h"
#include "stream/token.h"

namespace aeolic::stream {
namespace {

Json aboutRank(int rank, int ranks)
{
    return {{"rank", rank}, {"ranks", ranks}, {"host", "here"}, {"pid", 100 + rank}, {"direct", nullptr}};
}

/// A gateway that runs on this thread, and ranks on others.
class Links : public testing::Test {
protected:
    void listen(const std::string& host)
    {
        links = std::make_unique<JobLinks>(
            io, host, 0, kSilenceLimit,
            JobLinks::Events{[&] { joined = true; }, [&](const WireMessage& message) { said.push_back(message); },
                             [&](const std::optional<std::string>& why) { broken = why.value_or("gone"); }});
    }
    GatewayAddress expect(int ranks)
    {
        const std::string secret = makeToken();
        const std::string fingerprint = links->expect(secret, ranks);
        return {links->hosts(), links->port(), secret, fingerprint, false, false, {}, int(kSilenceLimit.count())};
    }
    /// Runs the gateway until it is so.
    bool until(const std::function<bool()>& condition, std::chrono::seconds time = std::chrono::seconds(30))
    {
        const auto end = SteadyClock::now() + time;
        while (!condition() && SteadyClock::now() < end) {
            io.restart();
            io.run_for(std::chrono::milliseconds(5));
        }
        return condition();
    }
    /// A rank that joins, says `message`, and waits for Quit.
    static std::thread rank(const GatewayAddress& address, const Json& about, const WireMessage& message,
                            std::atomic<int>& quit)
    {
        return std::thread([=, &quit] {
            JobLink link(address, about, [] {});
            if (message) link.send(message);
            quit += parseMessage(*link.receive(), Sender::gatewayToRank).type == MessageType::quit;
            link.close();
        });
    }
    void twoRanksMeet() { twoRanksMeet(expect(2)); }
    void twoRanksMeet(const GatewayAddress& address)
    {
        const WireMessage large = jsonMessage(MessageType::scene, "{\"x\":\"" + std::string(900'000, 'x') + "\"}");
        std::atomic<int> quit{0};
        std::vector<std::thread> ranks;
        for (int i = 0; i < 2; ++i) ranks.push_back(rank(address, aboutRank(i, 2), large, quit));
        EXPECT_TRUE(until([&] { return joined && said.size() == 2; }));
        EXPECT_EQ(links->pids(), (std::vector{100, 101}));
        for (const WireMessage& message : said) EXPECT_EQ(*message, *large);
        EXPECT_FALSE(broken);
        links->send(emptyMessage(MessageType::quit));
        EXPECT_TRUE(until([&] { return quit == 2; }));
        for (std::thread& one : ranks) one.join();
    }

    asio::io_context io;
    bool joined = false;
    std::vector<WireMessage> said;
    std::optional<std::string> broken;
    std::unique_ptr<JobLinks> links;
};

TEST_F(Links, OnThisHost)
{
    listen("127.0.0.1");
    EXPECT_EQ(expect(1).fingerprint, "") << "nothing leaves the host";
    twoRanksMeet();
}

TEST_F(Links, BetweenHostsAreEncryptedWithANewKeyForEachStart)
{
    listen("");
    const std::string first = expect(1).fingerprint, second = expect(1).fingerprint;
    EXPECT_EQ(first.size(), 64u);
    EXPECT_NE(first, second);
    twoRanksMeet();
}

TEST_F(Links, OfIpv6)
{
    try {
        listen("::1");
    } catch (const InputError&) {
        GTEST_SKIP() << "no IPv6 here";
    }
    twoRanksMeet();
}

TEST_F(Links, AddressesAndPortsThatAreNotToBeHad)
{
    EXPECT_THROW(listen("192.0.2.1"), InputError);
    EXPECT_THROW(listen("no.such.host.invalid"), InputError);
    listen("127.0.0.1");
    EXPECT_THROW(JobLinks(io, "127.0.0.1", links->port(), kSilenceLimit, {}), InputError);
}

/// More strangers than may wait: some are sent away at once, and the ranks get in beside the others.
TEST_F(Links, StrangersWhoWaitDoNotKeepRanksOut)
{
    listen("127.0.0.1");
    const GatewayAddress address = expect(2);
    std::vector<Tcp::socket> strangers;
    for (int i = 0; i < 200; ++i) {
        Tcp::socket& socket = strangers.emplace_back(io);
        socket.connect({asio::ip::address_v4::loopback(), links->port()});
        socket.non_blocking(true);
    }
    const auto sentAway = [&] {
        return std::count_if(strangers.begin(), strangers.end(), [](Tcp::socket& socket) {
            char byte = 0;
            boost::system::error_code error;
            socket.read_some(asio::buffer(&byte, 1), error);
            return error != asio::error::would_block;
        });
    };
    // Sooner than the time that each of them has to say who it is.
    EXPECT_TRUE(until([&] { return sentAway() >= 130; }, std::chrono::seconds(4)));
    EXPECT_LT(sentAway(), 150) << "so many may wait";
    twoRanksMeet(address);
}

TEST_F(Links, ARankOfTheJobBeforeIsAStranger)
{
    listen("127.0.0.1");
    const GatewayAddress old = expect(1);
    expect(1);
    std::atomic<bool> refused{false};
    std::thread late([&] {
        try {
            JobLink link(old, aboutRank(0, 1), [] {});
            link.receive();
        } catch (const std::exception&) {
            refused = true;
        }
    });
    EXPECT_TRUE(until([&] { return refused.load(); }));
    late.join();
    EXPECT_FALSE(joined);
    EXPECT_FALSE(broken);
}

/// No more files can be opened for a while: those who wait get in afterwards.
TEST_F(Links, TooManyOpenFilesAreNoFailure)
{
    listen("127.0.0.1");
    const GatewayAddress address = expect(1);
    Tcp::socket early(io);
    early.connect({asio::ip::address_v4::loopback(), links->port()});
    rlimit before{};
    getrlimit(RLIMIT_NOFILE, &before);
    const int next = dup(0);
    close(next);
    rlimit none = before;
    none.rlim_cur = rlim_t(next);
    setrlimit(RLIMIT_NOFILE, &none);
    until([] { return false; }, std::chrono::seconds(1));
    setrlimit(RLIMIT_NOFILE, &before);
    EXPECT_FALSE(broken);
    std::atomic<int> quit{0};
    std::thread one = rank(address, aboutRank(0, 1), nullptr, quit);
    EXPECT_TRUE(until([&] { return joined; }));
    links->send(emptyMessage(MessageType::quit));
    EXPECT_TRUE(until([&] { return quit == 1; }));
    one.join();
}

}  // namespace
}  // namespace aeolic::stream
