#include "output/output_check.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <utility>

#include "aeolic/error.h"

namespace aeolic {

namespace fs = std::filesystem;

void checkWritable(const std::string& path)
{
    const std::string expected = "a file that can be written";
    if (path.empty()) throw InputError("output file", "found an empty name", expected);
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) throw InputError(path, "found a folder", expected);
    if (fs::exists(status) && !fs::is_regular_file(status)) throw InputError(path, "found a device", expected);
    if (fs::exists(status) && access(path.c_str(), W_OK) != 0) throw InputError(path, "it is read-only", expected);

    fs::path folder = fs::path(path).parent_path();
    if (folder.empty()) folder = ".";
    if (!fs::is_directory(folder, error))
        throw InputError(path, "the folder " + folder.string() + " does not exist", expected);
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        throw InputError(path, "the folder " + folder.string() + ": " + std::strerror(errno), expected);
    if (fs::path(path).filename().string().size() > 240) throw InputError(path, "the name is too long", expected);
}

namespace {

/// A file that is being written. It has no name, or a temporary one, until it is complete.
class NewFile {
public:
    NewFile(const std::string& path, bool mayBeNameless) : path_(path), temporary_(path + "." + randomName() + ".tmp")
    {
        fs::path folder = fs::path(path).parent_path();
        if (folder.empty()) folder = ".";
        // A file opened by O_TMPFILE goes away by itself. It gets its name through /proc.
        if (mayBeNameless && access("/proc/self/fd", X_OK) == 0)
            file_ = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
        if (file_ >= 0) return;
        file_ = open(temporary_.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC, 0666);
        if (file_ < 0) fail();
        named_ = true;
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile()
    {
        if (file_ >= 0) close(file_);
        if (named_) std::remove(temporary_.c_str());
    }

    void write(const char* bytes, std::size_t count)
    {
        while (count > 0) {
            const ssize_t written = ::write(file_, bytes, count);
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail();
            bytes += written;
            count -= std::size_t(written);
        }
    }

    void complete()
    {
        if (!named_) {
            const std::string unnamed = "/proc/self/fd/" + std::to_string(file_);
            if (linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0) fail();
            named_ = true;
        }
        if (close(std::exchange(file_, -1)) != 0) fail();  // A full disk may be noticed only here.
        if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail();
        named_ = false;
    }

private:
    /// In a folder that others may write to, nobody has a link with this name.
    static std::string randomName()
    {
        std::random_device random;
        std::string name;
        for (int i = 0; i < 8; ++i) name += char('a' + random() % 26);
        return name;
    }
    [[noreturn]] void fail() const { throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno)); }

    std::string path_, temporary_;
    int file_ = -1;
    bool named_ = false;
};

}  // namespace

void writeTextFile(const std::string& path, const std::string& text, bool mayBeNameless)
{
    NewFile file(path, mayBeNameless);
    file.write(text.data(), text.size());
    file.complete();
}

}  // namespace aeolic
