#include "stream/gateway/supervisor.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>

#include "stream/gateway_address.h"
#include "stream/link/link_greeting.h"

namespace aeolic::stream {
namespace {

using namespace std::chrono_literals;

/// A supervisor whose job is a process that does nothing but last as long as its one rank, which the test plays.
class SupervisorTest : public testing::Test {
protected:
    void run(const std::string& surface, std::function<void(LinkSocket&)> rank)
    {
        Hub::Options options;
        options.scene.surface.spec = surface;
        Supervisor* supervisor = nullptr;
        Hub hub(options, [&](const WireMessage& message) { supervisor->send(message); });
        asio::io_context io(1);
        JobOptions job;
        job.words = {
            "sh", "-c",
            "read line; f='" + file_.string() + "'; echo \"$line\" >\"$f\"; while [ -e \"$f\" ]; do sleep 0.05; done"};
        job.told.silenceLimitS = 2;
        std::optional<Supervisor> here;
        here.emplace(io, job, hub, [&] {
            hopeless_ = true;
            here->stop([&] { io.stop(); });
        });
        supervisor = &*here;
        std::thread player([&] {
            LinkSocket socket{Tcp::socket(ranks_)};
            join(socket);
            rank(socket);
            std::filesystem::remove(file_);  // The process ends with its rank.
        });
        asio::steady_timer watch(io, 100ms);
        std::function<void(const boost::system::error_code&)> look = [&](const boost::system::error_code& error) {
            if (error) return;
            ++looks_;
            if (until_ && until_(hub)) return here->stop([&] { io.stop(); });
            watch.expires_after(20ms);
            watch.async_wait(look);
        };
        watch.async_wait(look);
        io.run_for(30s);
        EXPECT_TRUE(io.stopped());
        try {
            here->rethrowFailure();
        } catch (const std::exception& error) {
            failure_ = error.what();
        }
        if (hub.sceneError()) failure_ = *hub.sceneError();
        here.reset();  // Hangs up.
        player.join();
    }

    void TearDown() override { std::filesystem::remove(file_); }

    /// Until the gateway hangs up or asks to leave.
    void readAll(LinkSocket& socket, bool answer)
    {
        asio::co_spawn(
            ranks_,
            [&]() -> asio::awaitable<void> {
                for (;;) {
                    const WireMessage message = co_await socket.readMessage(Sender::gatewayToRank);
                    if (MessageType((*message)[2]) == MessageType::quit) co_return;
                    const WireMessage pong = emptyMessage(MessageType::pong);
                    const bool isPing = MessageType((*message)[2]) == MessageType::ping;
                    if (answer && isPing) co_await socket.write(*pong);
                }
            },
            asio::detached);  // It throws when the gateway has hung up.
        ranks_.restart();
        ranks_.run();
    }

    void join(LinkSocket& socket)
    {
        std::string line;
        for (int i = 0; i < 1000 && line.empty(); ++i) {
            std::this_thread::sleep_for(10ms);
            std::ifstream stream(file_);
            if (!std::getline(stream, line) || stream.eof()) line.clear();
        }
        ASSERT_NE(line, "");
        const GatewayAddress address = addressFromJson(line);
        EXPECT_EQ(address.silenceLimitS, 2);
        socket.tcp().connect({asio::ip::address_v4::loopback(), address.port});
        const Json about{{"rank", 0}, {"ranks", 1}, {"host", "node7"}, {"pid", 1}};
        asio::co_spawn(ranks_, greetGateway(socket, address.secret, about),
                       [](const std::exception_ptr& error) { EXPECT_FALSE(error) << "the gateway does not greet"; });
        ranks_.run();
    }

    std::filesystem::path file_ =
        std::filesystem::temp_directory_path() / ("aeolic_supervisor_" + std::to_string(getpid()));
    asio::io_context ranks_;
    std::function<bool(const Hub&)> until_;
    bool hopeless_ = false;
    std::string failure_;
    int looks_ = 0;
};

TEST_F(SupervisorTest, ASceneThatCannotBeSentEndsTheServerWithItsLine)
{
    run("caf\xe9.vtp", [&](LinkSocket& socket) { readAll(socket, true); });
    EXPECT_TRUE(hopeless_);
    EXPECT_NE(failure_.find("UTF-8"), std::string::npos) << failure_;
}

TEST_F(SupervisorTest, ARankThatAnswersPingsIsLeftAlone)
{
    until_ = [&](const Hub& hub) { return hub.status().restarts > 0 || looks_ > 250; };
    run("teapot", [&](LinkSocket& socket) { readAll(socket, true); });
    EXPECT_GT(looks_, 250) << "it was restarted";
}

TEST_F(SupervisorTest, ARankThatReadsButDoesNotAnswerIsNoticed)
{
    const auto start = std::chrono::steady_clock::now();
    until_ = [&](const Hub& hub) { return hub.status().restarts > 0; };
    run("teapot", [&](LinkSocket& socket) { readAll(socket, false); });
    EXPECT_GT(std::chrono::steady_clock::now() - start, 2s);
    EXPECT_LT(std::chrono::steady_clock::now() - start, 2s + 5s);
}

}  // namespace
}  // namespace aeolic::stream
