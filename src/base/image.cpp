#include "base/image.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "base/parallel.h"

namespace aeolic {
namespace {

// Threads that touch the same page wait for each other, and large memory lies on pages of 2 MiB.
constexpr std::size_t kTogether = std::size_t(4) << 20;

}  // namespace

void clearSides(void* rows, std::size_t rowBytes, std::size_t count, std::size_t left, std::size_t right)
{
    auto* const first = static_cast<std::byte*>(rows);
    const auto clear = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::memset(first + i * rowBytes, 0, left);
            std::memset(first + (i + 1) * rowBytes - right, 0, right);
        }
    };
    if (count * rowBytes < 2 * kTogether)
        clear(0, count);
    else
        parallelRanges(count, kTogether / rowBytes + 1, clear);
}

void moveBytes(void* to, const void* from, std::size_t bytes)
{
    auto* const target = static_cast<std::byte*>(to);
    const auto* const source = static_cast<const std::byte*>(from);
    const auto a = reinterpret_cast<std::uintptr_t>(to), b = reinterpret_cast<std::uintptr_t>(from);
    const bool apart = std::max(a, b) - std::min(a, b) >= bytes;
    constexpr std::size_t part = kTogether / 8;
    if (!apart || bytes < 2 * part) {
        std::memmove(to, from, bytes);
        return;
    }
    parallelRanges(bytes, part, [&](std::size_t begin, std::size_t end) {
        std::memcpy(target + begin, source + begin, end - begin);
    });
}

}  // namespace aeolic
