#include "reader/vtk/checks/obj_copy.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "aeolic/error.h"
#include "reader/vtk/checks/obj_check.h"

namespace aeolic {
namespace {

/// Corners "v/t/n" become "v".
std::string verticesOf(const std::string& line)
{
    std::istringstream words(line);
    std::string word, out;
    words >> word;
    if (word == "vt" || word == "vn") return "";
    if (word != "f" && word != "l" && word != "p") return line;
    out = word;
    while (words >> word) out += ' ' + word.substr(0, word.find('/'));
    return out;
}

bool writeAll(int descriptor, const std::string& text)
{
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t written = write(descriptor, text.data() + at, text.size() - at);
        if (written <= 0) return false;
        at += std::size_t(written);
    }
    return true;
}

}  // namespace

ObjCopy::ObjCopy(std::istream& file, const std::string& path) : descriptor_(memfd_create("obj", MFD_CLOEXEC))
{
    constexpr std::size_t kAtOnce = std::size_t(1) << 20;
    std::string text;
    bool fits = descriptor_ >= 0;
    ObjLines lines(file);
    while (fits && lines.next()) {
        text += verticesOf(lines.line()) + '\n';
        if (text.size() < kAtOnce) continue;
        fits = writeAll(descriptor_, text);
        text.clear();
    }
    if (fits && writeAll(descriptor_, text)) return;
    if (descriptor_ >= 0) close(descriptor_);
    throw InputError(path, "there is no memory for a copy without normals", "normals in all faces, or in none");
}

ObjCopy::~ObjCopy()
{
    close(descriptor_);
}

std::string ObjCopy::name() const
{
    return fmt::format("/proc/self/fd/{}", descriptor_);
}

std::unique_ptr<ObjCopy> checkedObj(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (checkObj(file, path)) return nullptr;
    file.clear();
    file.seekg(0);
    return std::make_unique<ObjCopy>(file, path);
}

}  // namespace aeolic
