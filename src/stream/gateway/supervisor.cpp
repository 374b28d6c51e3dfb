#include "stream/gateway/supervisor.h"

#include <fmt/format.h>
#include <signal.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>

#include "aeolic/error.h"
#include "stream/gateway/last_words.h"
#include "stream/link/accept.h"
#include "stream/token.h"

namespace aeolic::stream {

namespace asio = boost::asio;
using std::chrono::milliseconds;

namespace {

// A cluster's launcher may wait for nodes this long. A job that has not come by then will not come.
constexpr auto kJoinTime = std::chrono::minutes(2);
constexpr auto kLookAgain =
    milliseconds(100);                         // How often the process is looked at; no signal tells that it has ended.
constexpr auto kOnItsWay = milliseconds(700);  // Three ranks of a small scene join within half of it.

}  // namespace

Supervisor::Supervisor(asio::io_context& io, JobOptions options, Hub& hub, std::function<void()> hopeless)
    : io_(io),
      options_(std::move(options)),
      hub_(hub),
      links_(io, options_.linkHost, options_.linkPort, std::chrono::seconds(options_.told.silenceLimitS),
             {[this] { joined_ = true, wake_.cancel(); }, [this](const WireMessage& message) { take(message); },
              [this](const std::optional<std::string>& why) {
                  broken_ = true;
                  whyBroken_ = why;
                  wake_.cancel();
              }}),
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
        co_await pauseFor(milliseconds(20));
    }
    co_return process_->ended().has_value();
}

/// Ranks that are about to join can be asked to leave, like others. To hang up on them makes launchers complain.
asio::awaitable<void> Supervisor::joinsWithin(milliseconds time)
{
    const auto latest = SteadyClock::now() + time;
    while (!joined_ && !broken_ && process_ && !process_->ended() && SteadyClock::now() < latest)
        co_await sleep(milliseconds(20));
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
    if (whyBroken_) return *whyBroken_;
    if (const auto how = process_ ? process_->ended() : std::nullopt) {
        const std::string words = lastWords(process_->written());
        return "the renderer " + *how + (words.empty() ? "" : ": " + words);
    }
    if (broken_) return "a rank has gone";
    return fmt::format("the renderer did not come up within {} s", std::chrono::seconds(kJoinTime).count());
}

/// Returns early when something has happened.
asio::awaitable<void> Supervisor::sleep(milliseconds time)
{
    boost::system::error_code woken;
    wake_.expires_after(time);
    co_await wake_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
}

/// One start of the job, to its end. `why_` says how it ended.
asio::awaitable<void> Supervisor::runOnce()
{
    hub_.jobStarting();
    joined_ = broken_ = false;
    whyBroken_.reset();
    GatewayAddress address = options_.told;
    address.hosts = links_.hosts();
    address.port = links_.port();
    address.secret = makeToken();
    address.fingerprint = links_.expect(address.secret, options_.ranks);
    std::string notStarted;
    try {
        process_.emplace(options_.words, addressToJson(address) + "\n");
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {  // Too many processes or files for now.
        notStarted = error.what();
    }
    const auto latest = SteadyClock::now() + kJoinTime;
    bool told = false;
    while (!stopping_ && !broken_ && process_ && !process_->ended() && (joined_ || SteadyClock::now() < latest)) {
        if (joined_ && !std::exchange(told, true)) hub_.jobStarted(options_.ranks, links_.directPlaces());
        if (hub_.sceneError() || hub_.loadError() || hub_.overdue()) break;
        hub_.tick();
        co_await sleep(kLookAgain);
    }
    if (stopping_) {
        co_await joinsWithin(kOnItsWay);
        links_.send(emptyMessage(MessageType::quit));
    }
    if (process_ && broken_ && !whyBroken_)
        co_await processEndsWithin(milliseconds(500));  // Waits a moment, to be able to say how the process ended.
    why_ = notStarted.empty() ? whyItEnded() : notStarted;
}

/// The job is not started again by itself. Viewers are told why, and may ask for it.
asio::awaitable<void> Supervisor::untilAskedForAStart()
{
    while (!stopping_) {
        const bool asked = hub_.takeStartAskedFor();
        if (asked) break;
        co_await sleep(kLookAgain);
    }
    restarts_.onceMore();
}

asio::awaitable<void> Supervisor::run()
{
    while (!stopping_) {
        std::optional<std::string> cannotStart;
        try {
            co_await runOnce();
        } catch (const InputError& error) {
            cannotStart = error.what();
        }
        if (cannotStart) hub_.jobCannotStart(*cannotStart);
        if (stopping_ || hub_.sceneError()) break;
        co_await endProcess();
        if (!cannotStart) {
            restarts_.ended(hub_.jobEnded(why_), SteadyClock::now());
            const auto hopeless = restarts_.hopeless();
            if (hopeless) hub_.jobGivenUp(why_ + "; " + *hopeless);
            cannotStart = hopeless;
        }
        if (cannotStart) {
            co_await untilAskedForAStart();
            continue;
        }
        const milliseconds pause = restarts_.pause();
        if (pause > milliseconds(0))
            hub_.jobWaits(fmt::format("{}; starting again in {:.1f} s", why_, double(pause.count()) / 1000));
        co_await sleep(pause);
    }
    // A job that never came was not asked to leave, and nothing is gained by waiting for it.
    if (stopping_ && process_ && joined_) co_await processEndsWithin(milliseconds(1500));
    co_await endProcess();
    if (hub_.sceneError() && !stopping_) hopeless_();
    while (!stopping_) co_await sleep(std::chrono::hours(1));  // Nothing else can happen any more.
    if (stopped_) stopped_();
}

}  // namespace aeolic::stream
