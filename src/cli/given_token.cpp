#include "cli/given_token.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "aeolic/error.h"
#include "data/reading/owned_file.h"
#include "stream/token.h"

namespace aeolic {
namespace {

constexpr const char* kVariable = "AEOLIC_TOKEN";

}  // namespace

std::string tokenFromFile(const std::string& path)
{
    const std::string where = "--token-file " + path, expected = "a file with a token";
    const OwnedFile file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status {};
    if (!file || fstat(file.get(), &status) != 0) throw InputError(where, std::strerror(errno), expected);
    if (S_ISREG(status.st_mode) && (status.st_mode & (S_IRWXG | S_IRWXO)))
        throw InputError(where, "others may read it", "a file that is yours alone (chmod 600)");
    std::string text;
    char buffer[512];
    ssize_t got = 0;
    while (text.size() <= stream::kLongestToken + 1 && (got = read(file.get(), buffer, sizeof(buffer))) != 0) {
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw InputError(where, std::strerror(errno), expected);
        text.append(buffer, std::size_t(got));
    }
    if (text.ends_with('\n')) text.pop_back();
    if (text.ends_with('\r')) text.pop_back();
    stream::checkToken(where, text);
    return text;
}

std::string tokenFromEnvironment()
{
    char* value = std::getenv(kVariable);
    std::string token = value ? value : "";
    if (value) std::memset(value, 0, token.size());  // /proc shows what the process was started with.
    unsetenv(kVariable);
    if (!token.empty()) stream::checkToken(kVariable, token);
    return token;
}

}  // namespace aeolic
