#include "data/load/ask_once.h"

#include <cstdint>
#include <cstring>

#include "data/reading/known_answers.h"

namespace aeolic {
namespace {

/// Collective. What the first rank of this host gives.
Bytes ofFirstOnHost(Agreement& agreement, const Bytes& mine)
{
    // The others do not know its length, so it stands in front.
    const bool gives = agreement.isFirstOnHost();
    const std::shared_ptr<Bytes> framed = gives ? std::make_shared<Bytes>(byteMessage(mine)) : nullptr;
    const std::shared_ptr<const void> given = agreement.shareOnHost(
        gives ? std::shared_ptr<const void>(framed, framed->data()) : nullptr, gives ? framed->size() : 0);
    const auto* bytes = static_cast<const std::byte*>(given.get());
    std::uint64_t count = 0;
    std::memcpy(&count, bytes, sizeof count);
    return {bytes + sizeof count, bytes + sizeof count + count};
}

}  // namespace

void askOncePerHost(Agreement& agreement, const std::function<void()>& action)
{
    KnownAnswers known;
    const bool isFirst = agreement.isFirstOnHost();
    agreement.readTogether([&] {
        if (isFirst) action();
    });
    if (!agreement.part().split()) return;
    const Bytes answers = ofFirstOnHost(agreement, isFirst ? known.message() : Bytes());
    agreement.together([&] {
        if (isFirst) return;
        ByteReader message(answers);
        known.take(message);
        action();
    });
}

}  // namespace aeolic
