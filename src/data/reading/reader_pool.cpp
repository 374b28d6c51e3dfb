#include "data/reading/reader_pool.h"

#include <unistd.h>

#include <mutex>
#include <vector>

namespace aeolic {
namespace {

/// Readers that wait for a file. A copy of this process that fork() makes leaves them to their owner.
class ReaderPool {
public:
    std::unique_ptr<ReaderProcess> take()
    {
        const std::lock_guard lock(mutex_);
        ofThisProcess();
        while (!waiting_.empty()) {
            auto process = std::move(waiting_.back());
            waiting_.pop_back();
            if (process->ready()) return process;  // One that has ended meanwhile is dropped.
        }
        return nullptr;
    }

    void giveBack(std::unique_ptr<ReaderProcess> process)
    {
        const std::lock_guard lock(mutex_);
        ofThisProcess();
        if (keepers_ > 0 && process->ready()) waiting_.push_back(std::move(process));
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
    process_->tell(PacketKind::close);
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
