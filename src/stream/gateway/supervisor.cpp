#include "stream/gateway/supervisor.h"

#include <fmt/format.h>
#include <signal.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>

#include "aeolic/error.h"
#include "stream/gateway_address.h"
#include "stream/token.h"

namespace aeolic::stream {

namespace asio = boost::asio;
using std::chrono::milliseconds;

namespace {

// A cluster's launcher may wait for nodes this long. A job that has not come by then will not come.
constexpr auto kJoinTime = std::chrono::minutes(2);
constexpr auto kLookAgain =
    milliseconds(100);  // How often the process is looked at; no signal tells that it has ended.

milliseconds pauseBefore(int failures)
{
    return failures == 0 ? milliseconds(0) : milliseconds(250 << std::min(failures - 1, 5));
}

}  // namespace

Supervisor::Supervisor(asio::io_context& io, JobOptions options, Hub& hub, std::function<void()> hopeless)
    : io_(io),
      options_(std::move(options)),
      hub_(hub),
      links_(io, options_.linkHost, options_.linkPort,
             {[this] { joined_ = true, wake_.cancel(); }, [this](const WireMessage& message) { take(message); },
              [this](const std::string& why) { broken_ = why, wake_.cancel(); }}),
      wake_(io),
      hopeless_(std::move(hopeless))
{
    asio::co_spawn(io_, run(), [this](const std::exception_ptr& error) {
        if (!error) return;
        failure_ = error;  // Nobody would start the job again: the server ends.
        hopeless_();
    });
}

void Supervisor::rethrowFailure() const
{
    if (failure_) std::rethrow_exception(failure_);
}

void Supervisor::take(const WireMessage& message)
{
    hub_.jobSaid(message);
    if (hub_.sceneError() || hub_.loadError()) wake_.cancel();
}

void Supervisor::stop(std::function<void()> done)
{
    stopping_ = true;
    if (failure_) return done();  // run() has ended: nobody else would call it.
    stopped_ = std::move(done);
    wake_.cancel();
}

asio::awaitable<bool> Supervisor::processEndsWithin(milliseconds time)
{
    for (auto left = time; left > milliseconds(0); left -= milliseconds(20)) {
        if (process_->ended()) co_return true;
        asio::steady_timer pause(io_, milliseconds(20));
        co_await pause.async_wait(asio::use_awaitable);
    }
    co_return process_->ended().has_value();
}

/// Ranks leave when their links are closed, and the launcher leaves after them. Those that do not leave are ended.
asio::awaitable<void> Supervisor::endProcess()
{
    links_.hangUp();
    if (!process_) co_return;
    // Each wait is a statement of its own: GCC 12 compiles waits within nested conditions to traps.
    bool gone = co_await processEndsWithin(milliseconds(700));
    if (!gone) process_->signal(SIGTERM);
    gone = co_await processEndsWithin(milliseconds(gone ? 0 : 1500));
    if (!gone) process_->signal(SIGKILL);
    process_.reset();
}

std::string Supervisor::whyItEnded()
{
    if (hub_.loadError()) return *hub_.loadError();
    if (const auto overdue = hub_.overdue()) return *overdue;
    if (const auto how = process_ ? process_->ended() : std::nullopt) return "the renderer " + *how;
    if (broken_) return *broken_;
    return fmt::format("the renderer did not come up within {} s", std::chrono::seconds(kJoinTime).count());
}

asio::awaitable<void> Supervisor::run()
{
    int failures = 0;
    while (!stopping_) {
        hub_.jobStarting();
        joined_ = false;
        broken_.reset();
        const std::string secret = makeToken();
        const std::string fingerprint = links_.expect(secret, options_.ranks);
        std::string notStarted;
        try {
            process_.emplace(options_.words,
                             addressToJson({links_.hosts(), links_.port(), secret, fingerprint, options_.direct,
                                            options_.directEverywhere, options_.directPorts}) +
                                 "\n");
        } catch (const InputError& error) {
            hub_.jobCannotStart(error.what());
            break;
        } catch (const std::exception& error) {  // Too many processes or files for now.
            notStarted = error.what();
        }
        const auto latest = SteadyClock::now() + kJoinTime;
        bool told = false;
        while (!stopping_ && !broken_ && process_ && !process_->ended() && (joined_ || SteadyClock::now() < latest)) {
            if (joined_ && !std::exchange(told, true)) hub_.jobStarted(options_.ranks, links_.directPlaces());
            if (hub_.sceneError() || hub_.loadError() || hub_.overdue()) break;
            hub_.tick();
            boost::system::error_code woken;
            wake_.expires_after(kLookAgain);
            co_await wake_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
        }
        if (hub_.sceneError()) break;
        if (stopping_) links_.send(emptyMessage(MessageType::quit));
        if (process_ && broken_)
            co_await processEndsWithin(milliseconds(500));  // Waits a moment, to be able to say how the process ended.
        const std::string why = notStarted.empty() ? whyItEnded() : notStarted;
        if (stopping_) break;
        co_await endProcess();
        failures = hub_.jobEnded(why) ? 0 : failures + 1;
        if (failures >= kMostFailures) {
            hub_.jobGivenUp(fmt::format("{}; given up after {} starts without a picture", why, failures));
            break;
        }
        const auto pause = pauseBefore(failures);
        if (failures > 0)
            hub_.jobWaits(fmt::format("{}; starting again in {:.1f} s", why, double(pause.count()) / 1000));
        boost::system::error_code woken;
        wake_.expires_after(pause);
        co_await wake_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
    }
    if (stopping_ && process_) co_await processEndsWithin(milliseconds(1500));
    co_await endProcess();
    if (hub_.sceneError() && !stopping_) hopeless_();
    while (!stopping_) {  // Nothing else can happen any more.
        boost::system::error_code woken;
        wake_.expires_at(SteadyClock::time_point::max());
        co_await wake_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
    }
    if (stopped_) stopped_();
}

}  // namespace aeolic::stream
