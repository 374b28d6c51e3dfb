#include "cluster/comm/together.h"

#include <algorithm>
#include <cstdint>
#include <new>
#include <span>
#include <stdexcept>
#include <string_view>

#include "aeolic/error.h"
#include "base/fnv.h"
#include "base/text.h"

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
    if (line.size() > kLongestQuoted) line = line.substr(0, characterStart(line, kLongestQuoted)) + "…";
    return "'" + line + "'";
}

/// What a rank says at the begin of a call.
struct CallReport {
    std::uint64_t call, arguments, failed;
    bool operator==(const CallReport&) const = default;
};

std::uint64_t hashOf(std::string_view text)
{
    Fnv hash;
    for (const char c : text) hash.mix(static_cast<unsigned char>(c));
    return hash.value;
}

/// Collective. Throws on all ranks what the lowest reports.
void throwFirst(Communicator& communicator, const std::string& mine, bool namesRank)
{
    const std::vector<std::string> reports = allGatherText(communicator, mine);
    const auto failed = std::find_if(reports.begin(), reports.end(),
                                     [](const std::string& r) { return Outcome(r[0]) != Outcome::fine; });
    if (failed == reports.end()) return;
    const bool alike = std::all_of(reports.begin(), reports.end(), [&](const std::string& r) { return r == *failed; });
    const std::string message =
        (alike || !namesRank ? "" : "rank " + std::to_string(failed - reports.begin()) + ": ") + failed->substr(1);
    if (Outcome((*failed)[0]) == Outcome::inputError) throw AgreedInputError(message);
    throw AgreedFailure(message);
}

}  // namespace

void runTogether(Communicator& communicator, const std::function<void()>& action, bool namesRank)
{
    if (communicator.size() == 1) return action();
    throwFirst(communicator, outcomeOf(action), namesRank);
}

void retelling(const std::function<void()>& action, const std::function<std::string(std::string)>& told)
{
    try {
        action();
    } catch (const InputError& error) {
        const std::string text = told(error.what());
        if (dynamic_cast<const Agreed*>(&error)) throw AgreedInputError(text);
        throw InputError(text);
    }
}

void requireSame(Communicator& communicator, const std::string& what, const std::string& value)
{
    const std::vector<std::string> all = allGatherText(communicator, value);
    for (std::size_t r = 1; r < all.size(); ++r)
        if (all[r] != all[0])
            throw AgreedInputError(what, "rank " + std::to_string(r) + " has " + quoted(all[r], all[0]),
                                   quoted(all[0], all[r]) + " as on rank 0");
}

void callTogether(Communicator& communicator, const char* call, const std::function<std::string()>& arguments,
                  const std::function<void()>& action)
{
    if (communicator.size() == 1) return action();
    const std::string given = arguments(), outcome = outcomeOf(action);
    const CallReport mine{hashOf(call), hashOf(given), Outcome(outcome[0]) != Outcome::fine};
    std::vector<CallReport> all(std::size_t(communicator.size()), mine);
    communicator.allGatherInPlace(std::as_writable_bytes(std::span(all)),
                                  std::vector<std::size_t>(all.size(), sizeof mine));
    const auto isFine = [&](const CallReport& report) { return report == all[0] && !report.failed; };
    if (std::all_of(all.begin(), all.end(), isFine)) return;
    requireSame(communicator, "the ranks' calls", call);
    requireSame(communicator, call, given);
    throwFirst(communicator, outcome, true);
}

std::vector<std::string> distinctOfAll(Communicator& communicator, const std::vector<std::string>& mine)
{
    std::string lines;
    for (const std::string& text : mine) lines += withoutControls(text) + '\n';
    std::vector<std::string> distinct;
    for (const std::string& all : allGatherText(communicator, lines))
        for (const std::string_view text : splitText(std::string_view(all).substr(0, all.rfind('\n')), '\n'))
            if (!all.empty() && std::find(distinct.begin(), distinct.end(), text) == distinct.end())
                distinct.emplace_back(text);
    return distinct;
}

}  // namespace aeolic
