#include "cli/address_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "aeolic/error.h"
#include "stream/token.h"

namespace aeolic {
namespace {

[[noreturn]] void fail(const std::string& path)
{
    throw InputError("--address-file " + path, std::strerror(errno), "a file that can be written");
}

bool writeAll(int file, const std::string& text)
{
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t written = write(file, text.data() + done, text.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        done += std::size_t(written);
    }
    return true;
}

}  // namespace

AddressFile::AddressFile(const std::string& path, const std::string& text) : path_(path)
{
    // In a folder that others may write to, nobody can have prepared this name.
    const std::string fresh = path + "." + stream::makeToken() + ".tmp";
    const int file = open(fresh.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC, 0600);
    if (file < 0) fail(path);
    struct stat status {};
    const bool written = fchmod(file, 0600) == 0 && writeAll(file, text) && fstat(file, &status) == 0;
    const bool closed = close(file) == 0;
    if (!written || !closed || std::rename(fresh.c_str(), path.c_str()) != 0) {
        const int why = errno;
        std::remove(fresh.c_str());
        errno = why;
        fail(path);
    }
    device_ = status.st_dev;
    inode_ = status.st_ino;
}

AddressFile::~AddressFile()
{
    struct stat status {};
    if (lstat(path_.c_str(), &status) == 0 && status.st_dev == device_ && status.st_ino == inode_)
        std::remove(path_.c_str());
}

std::string defaultAddressFile(const std::string& address)
{
    const std::size_t start = address.find("://") + 3;
    std::string name = address.substr(start, address.find('/', start) - start);
    std::replace(name.begin(), name.end(), ':', '-');
    const char* home = std::getenv("HOME");
    if (!home || *home == '\0')
        throw InputError("--address-file", "missing, and there is no home to write the address to",
                         "a file for the address, because standard output is a file that others may read");
    const std::string folder = std::string(home) + "/.aeolic";
    std::string path = folder + "/" + name;
    if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) fail(path);
    return path;
}

}  // namespace aeolic
