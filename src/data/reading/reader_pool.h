#pragma once

#include <memory>

#include "data/reading/reader_process.h"

namespace aeolic {

/// A reader for one file at a time. Goes back to the others when it is not needed any longer, if it is ready for the
/// next file, and if anybody keeps readers.
class ReaderLease {
public:
    /// One that waits, or a new one. Any thread. Throws InputError.
    ReaderLease();
    ReaderLease(ReaderLease&&) noexcept = default;
    ReaderLease& operator=(ReaderLease&&) = delete;
    ~ReaderLease();

    ReaderProcess* operator->() const { return process_.get(); }

private:
    std::unique_ptr<ReaderProcess> process_;
};

/// Readers that have nothing to do wait for the next file as long as an object of this class lives. A scene has one.
class KeptReaders {
public:
    KeptReaders();
    KeptReaders(const KeptReaders&) = delete;
    KeptReaders& operator=(const KeptReaders&) = delete;
    ~KeptReaders();
};

}  // namespace aeolic
