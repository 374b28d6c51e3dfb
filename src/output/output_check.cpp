#include "output/output_check.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "aeolic/error.h"
#include "description/option_rules.h"
#include "output/new_file.h"

namespace aeolic {

namespace fs = std::filesystem;

namespace {

constexpr const char* expected = "a file that can be written";

}  // namespace

void checkFileName(const std::string& path)
{
    if (path.empty()) throw InputError("output file", "found an empty name", expected);
    if (path.find('\0') != std::string::npos)
        throw InputError("output file", "found " + inQuotes(path), "a name without a byte of 0");
}

void checkWritable(const std::string& path)
{
    checkFileName(path);
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

void writeTextFile(const std::string& path, const std::string& text, bool mayBeNameless)
{
    checkFileName(path);
    NewFile file(path, mayBeNameless);
    file.write(text);
    file.complete();
}

}  // namespace aeolic
