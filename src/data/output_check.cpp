#include "data/output_check.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

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

void writeTextFile(const std::string& path, const std::string& text)
{
    const std::string temporary = path + "." + std::to_string(getpid()) + ".tmp";
    const auto fail = [&](int reason) {
        std::remove(temporary.c_str());
        throw std::runtime_error(path + ": cannot be written: " + std::strerror(reason));
    };
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (!file) fail(errno);
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    const int writeError = errno;
    const bool closed = std::fclose(file) == 0;  // A full disk may show only here.
    if (!written || !closed) fail(written ? errno : writeError);
    if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(errno);
}

}  // namespace aeolic
