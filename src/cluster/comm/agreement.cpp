#include "cluster/comm/agreement.h"

#include <algorithm>
#include <new>
#include <stdexcept>

#include "aeolic/error.h"

namespace aeolic {
namespace {

// The first byte of what a rank reports; the message follows.
enum class Outcome : char { fine = 'f', error = 'e', inputError = 'i' };

struct AgreedInputError final : InputError, Agreed {
    using InputError::InputError;
};
struct AgreedFailure final : std::runtime_error, Agreed {
    using std::runtime_error::runtime_error;
};

std::string report(Outcome outcome, const std::string& message)
{
    return char(outcome) + message;
}

std::string outcomeOf(const std::function<void()>& action)
{
    try {
        action();
    } catch (const InputError& error) {
        return report(Outcome::inputError, error.what());
    } catch (const std::bad_alloc&) {
        return report(Outcome::error, "out of memory");
    } catch (const std::exception& error) {
        return report(Outcome::error, error.what());
    } catch (...) {
        return report(Outcome::error, "an unknown error");
    }
    return report(Outcome::fine, "");
}

std::vector<std::string> allGatherText(Communicator& communicator, const std::string& mine)
{
    std::vector<std::string> all;
    for (const Bytes& bytes : communicator.allGather(std::as_bytes(std::span(mine))))
        all.emplace_back(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return all;
}

/// The part of `value` to show where `other` differs: the first line that does. A long line is cut off.
std::string quoted(const std::string& value, const std::string& other)
{
    constexpr std::size_t kLongestQuoted = 100;
    const auto differsAt =
        std::size_t(std::mismatch(value.begin(), value.end(), other.begin(), other.end()).first - value.begin());
    const std::size_t lineBreak = differsAt > 0 ? value.rfind('\n', differsAt - 1) : std::string::npos;
    const std::size_t begin = value.find_first_not_of(' ', lineBreak == std::string::npos ? 0 : lineBreak + 1);
    if (begin == std::string::npos) return "nothing";
    std::string line = value.substr(begin, value.find('\n', begin) - begin);
    if (line.ends_with(',')) line.pop_back();
    if (line.size() > kLongestQuoted) line = line.substr(0, kLongestQuoted) + "…";
    return "'" + line + "'";
}

}  // namespace

void runTogether(Communicator& communicator, const std::function<void()>& action, bool namesRank)
{
    if (communicator.size() == 1) return action();
    const std::vector<std::string> reports = allGatherText(communicator, outcomeOf(action));
    const auto failed = std::find_if(reports.begin(), reports.end(),
                                     [](const std::string& r) { return Outcome(r[0]) != Outcome::fine; });
    if (failed == reports.end()) return;
    const bool alike = std::all_of(reports.begin(), reports.end(), [&](const std::string& r) { return r == *failed; });
    const std::string message =
        (alike || !namesRank ? "" : "rank " + std::to_string(failed - reports.begin()) + ": ") + failed->substr(1);
    if (Outcome((*failed)[0]) == Outcome::inputError) throw AgreedInputError(message);
    throw AgreedFailure(message);
}

void requireSame(Communicator& communicator, const std::string& what, const std::string& value)
{
    const std::vector<std::string> all = allGatherText(communicator, value);
    for (std::size_t r = 1; r < all.size(); ++r)
        if (all[r] != all[0])
            throw AgreedInputError(what, "rank " + std::to_string(r) + " has " + quoted(all[r], all[0]),
                                   quoted(all[0], all[r]) + " as on rank 0");
}

std::vector<std::string> distinctOfAll(Communicator& communicator, const std::vector<std::string>& mine)
{
    std::string lines;
    for (const std::string& text : mine) lines += text + '\n';
    std::vector<std::string> distinct;
    for (const std::string& all : allGatherText(communicator, lines)) {
        std::size_t begin = 0;
        for (std::size_t end; (end = all.find('\n', begin)) != std::string::npos; begin = end + 1) {
            std::string text = all.substr(begin, end - begin);
            if (std::find(distinct.begin(), distinct.end(), text) == distinct.end())
                distinct.push_back(std::move(text));
        }
    }
    return distinct;
}

}  // namespace aeolic
