#pragma once

#include <cstdint>

namespace aeolic {

/// FNV-1a over whole numbers instead of bytes. It tells data apart; it is no defence against forgery.
struct Fnv {
    std::uint64_t value = 14695981039346656037u;

    void mix(std::uint64_t number) { value = (value ^ number) * 1099511628211u; }
};

}  // namespace aeolic
