#include "data/reading/known_answers.h"

#include <span>

namespace aeolic {
namespace {

thread_local KnownAnswers* innermost = nullptr;

std::string keyOf(std::span<const std::byte> request)
{
    return {reinterpret_cast<const char*>(request.data()), request.size()};
}

}  // namespace

KnownAnswers::KnownAnswers() : outer_(innermost)
{
    innermost = this;
}

KnownAnswers::~KnownAnswers()
{
    innermost = outer_;
}

Bytes KnownAnswers::message() const
{
    ByteWriter writer;
    writer.add(std::uint64_t(answers_.size()));
    for (const auto& [request, answer] : answers_) {
        writer.add(request);
        writer.add(answer);
    }
    return writer.take();
}

void KnownAnswers::take(ByteReader& message)
{
    std::uint64_t count = 0;
    message.read(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        std::string request;
        std::span<const std::byte> answer;
        message.read(request);
        message.read(answer);
        answers_.insert_or_assign(std::move(request), Bytes(answer.begin(), answer.end()));
    }
}

KnownAnswers* KnownAnswers::current()
{
    return innermost;
}

const Bytes* KnownAnswers::find(const Bytes& request) const
{
    const auto found = answers_.find(keyOf(request));
    return found == answers_.end() ? nullptr : &found->second;
}

void KnownAnswers::keep(const Bytes& request, const Bytes& answer)
{
    answers_.insert_or_assign(keyOf(request), answer);
}

}  // namespace aeolic
