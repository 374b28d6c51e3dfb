#include "data/reading/reader_pool.h"

#include <unistd.h>

#include <mutex>
#include <vector>

namespace aeolic {
namespace {

constexpr int kCloseMs = 50;  // To close a file. A new reader is there sooner than one that takes longer.

/// Readers that wait for a file. A copy of this process that fork() makes leaves them to their owner.
class ReaderPool {
public:
    std::unique_ptr<ReaderProcess> take()
    {
        while (auto process = next())
            if (process->ready(kCloseMs)) return process;  // One that has ended meanwhile, or hangs, is dropped.
        return nullptr;
    }

    void giveBack(std::unique_ptr<ReaderProcess> process)
    {
        const std::lock_guard lock(mutex_);
        ofThisProcess();
        if (keepers_ > 0) waiting_.push_back(std::move(process));
    }

    void keep(int change)
    {
        std::vector<std::unique_ptr<ReaderProcess>> unwanted;
        const std::lock_guard lock(mutex_);
        ofThisProcess();
        keepers_ += change;
        if (keepers_ == 0) unwanted.swap(waiting_);
    }

private:
    std::unique_ptr<ReaderProcess> next()
    {
        const std::lock_guard lock(mutex_);
        ofThisProcess();
        if (waiting_.empty()) return nullptr;
        auto process = std::move(waiting_.back());
        waiting_.pop_back();
        return process;
    }

    void ofThisProcess()
    {
        if (owner_ == getpid()) return;
        owner_ = getpid();
        waiting_.clear();
    }

    std::mutex mutex_;
    pid_t owner_ = getpid();
    int keepers_ = 0;
    std::vector<std::unique_ptr<ReaderProcess>> waiting_;
};

ReaderPool& pool()
{
    static ReaderPool all;
    return all;
}

}  // namespace

ReaderLease::ReaderLease() : process_(pool().take())
{
    if (!process_) process_ = std::make_unique<ReaderProcess>();
}

ReaderLease::~ReaderLease()
{
    if (!process_) return;
    process_->close();
    pool().giveBack(std::move(process_));
}

KeptReaders::KeptReaders()
{
    pool().keep(1);
}

KeptReaders::~KeptReaders()
{
    pool().keep(-1);
}

}  // namespace aeolic
