#include "data/reading/reader_program.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "aeolic/error.h"

namespace aeolic {

std::string readerProgram()
{
    namespace fs = std::filesystem;
    if (const char* named = std::getenv("AEOLIC_READER"); named && *named) {
        if (access(named, X_OK) != 0)
            throw InputError("AEOLIC_READER", std::string(named) + " is not a program", "the program aeolic-reader");
        return named;
    }
    Dl_info info{};
    std::error_code error;
    fs::path folder;
    if (dladdr(reinterpret_cast<const void*>(&readerProgram), &info) != 0 && info.dli_fname)
        folder = fs::canonical(info.dli_fname, error).parent_path();
    if (folder.empty())
        throw InputError("aeolic-reader", "not found: nobody knows where the library is", "AEOLIC_READER=PATH");
    for (const char* place : {"aeolic-reader", "libexec/aeolic/aeolic-reader", "../libexec/aeolic/aeolic-reader",
                              "../../libexec/aeolic/aeolic-reader"}) {
        std::string program = (folder / place).string();
        if (access(program.c_str(), X_OK) == 0) return program;
    }
    throw InputError("aeolic-reader", "not found in " + folder.string() + " or libexec/aeolic near it",
                     "the program that reads files, installed with the library, or AEOLIC_READER=PATH");
}

}  // namespace aeolic
