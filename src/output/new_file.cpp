#include "output/new_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <utility>

namespace aeolic {
namespace {

/// A name beside `path` that nobody can have prepared, ending in .tmp.
std::string temporaryName(const std::string& path)
{
    std::random_device random;  // In a folder that others may write to, nobody has a link with this name.
    std::string name = path + ".";
    for (int i = 0; i < 8; ++i) name += char('a' + random() % 26);
    return name + ".tmp";
}

}  // namespace

NewFile::NewFile(const std::string& path, bool mayBeNameless) : path_(path), temporary_(temporaryName(path))
{
    std::error_code unknown;
    const auto status = std::filesystem::status(path, unknown);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))  // A rename would replace it.
        throw std::runtime_error(path + ": cannot be written: it is not a file");
    std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (folder.empty()) folder = ".";
    // A file opened by O_TMPFILE goes away by itself. It gets its name through /proc.
    if (mayBeNameless && access("/proc/self/fd", X_OK) == 0)
        file_ = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    if (file_ >= 0) return;
    file_ = open(temporary_.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC, 0666);
    if (file_ < 0) fail();
    named_ = true;
}

NewFile::~NewFile()
{
    if (file_ >= 0) close(file_);
    if (named_) std::remove(temporary_.c_str());
}

void NewFile::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(file_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail();
        bytes.remove_prefix(std::size_t(written));
    }
}

std::string NewFile::nameFor(int there) const
{
    return named_ ? temporary_ : "/proc/self/fd/" + std::to_string(there);
}

void NewFile::complete()
{
    if (!named_) {
        const std::string unnamed = "/proc/self/fd/" + std::to_string(file_);
        const auto link = [&](const std::string& name) {
            return linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
        };
        // Where nothing is to be replaced the file gets its name at once. No moment is left for another one.
        if (link(path_)) {
            if (close(std::exchange(file_, -1)) == 0) return;
            std::remove(path_.c_str());
            fail();
        }
        if (errno != EEXIST || !link(temporary_)) fail();
        named_ = true;
    }
    if (close(std::exchange(file_, -1)) != 0) fail();  // A full disk may be noticed only here.
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail();
    named_ = false;
}

void NewFile::fail() const
{
    throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

}  // namespace aeolic
