#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace aeolic::cpu {

/// Bits [from, to) of a word, 0 <= from < to <= 64.
inline std::uint64_t bitsBetween(int from, int to)
{
    return (~std::uint64_t{0} >> (64 - (to - from))) << from;
}

/// Other threads set bits meanwhile; in whichever order, the bits in the end are the same.
inline bool hasBits(const std::uint64_t& word, std::uint64_t wanted)
{
    return (std::atomic_ref(const_cast<std::uint64_t&>(word)).load(std::memory_order_relaxed) & wanted) == wanted;
}

inline void setBits(std::uint64_t& word, std::uint64_t wanted)
{
    if (!hasBits(word, wanted)) std::atomic_ref(word).fetch_or(wanted, std::memory_order_relaxed);
}

/// Sets bits that mostly are in the same word as those before: what is set there together is set at once.
class BitsToSet {
public:
    explicit BitsToSet(std::uint64_t* words) : words_(words) {}
    BitsToSet(const BitsToSet&) = delete;
    BitsToSet& operator=(const BitsToSet&) = delete;
    ~BitsToSet() { setAll(); }

    void add(std::size_t word, std::uint64_t bits)
    {
        if (word != word_) {
            setAll();
            word_ = word;
            bits_ = 0;
        }
        bits_ |= bits;
    }

private:
    void setAll()
    {
        if (bits_ != 0) setBits(words_[word_], bits_);
    }

    std::uint64_t* words_;
    std::size_t word_ = 0;
    std::uint64_t bits_ = 0;
};

}  // namespace aeolic::cpu
