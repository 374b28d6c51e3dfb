#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace aeolic::stream {

/// Memory for one call of an encoder; it is not cleared. Each thread keeps its own from call to call, up to kKeptBytes:
/// touching memory that is new from the system takes longer than encoding it by LZ4. A thread may have one at a time.
class Scratch {
public:
    static constexpr std::size_t kKeptBytes = std::size_t(16) << 20;  ///< Bands of 64 rows need 1 MiB.

    /// Throws std::bad_alloc.
    explicit Scratch(std::size_t bytes)
    {
        if (bytes > kKeptBytes) {
            own_ = std::make_unique_for_overwrite<std::uint8_t[]>(bytes);
            data_ = own_.get();
            return;
        }
        thread_local std::unique_ptr<std::uint8_t[]> kept;
        thread_local std::size_t keptBytes = 0;
        if (bytes > keptBytes) {
            keptBytes = 0;
            kept.reset();  // Freed before the new memory is taken, so that both are never held.
            kept = std::make_unique_for_overwrite<std::uint8_t[]>(bytes);
            keptBytes = bytes;
        }
        data_ = kept.get();
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    // The analyzer takes `kept` for a local variable, which it is not.
    std::uint8_t* data() const { return data_; }  // NOLINT(clang-analyzer-cplusplus.NewDelete)

private:
    std::unique_ptr<std::uint8_t[]> own_;
    std::uint8_t* data_ = nullptr;
};

}  // namespace aeolic::stream
