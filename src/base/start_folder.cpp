#include "base/start_folder.h"

#include <filesystem>
#include <system_error>

namespace aeolic {

StartFolder::StartFolder()
{
    std::error_code gone;
    const std::filesystem::path here = std::filesystem::current_path(gone);
    if (!gone) prefix_ = (here / "." / "").string();
}

std::string StartFolder::absolute(const std::string& path) const
{
    return path.empty() || std::filesystem::path(path).is_absolute() ? path : prefix_ + path;
}

std::string StartFolder::asGiven(std::string message) const
{
    if (prefix_.empty()) return message;
    for (std::size_t at = 0; (at = message.find(prefix_, at)) != std::string::npos;) message.erase(at, prefix_.size());
    return message;
}

}  // namespace aeolic
