#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace aeolic {

/// A file that is being written. It has no name, or a temporary one, until it is complete: `path` is then complete, or
/// what it was before. Most file systems of Linux can hold files without a name; there nothing unfinished is left,
/// whatever ends the program, unless it ends in the moment when one file takes another one's place. Then, on others, or
/// with `mayBeNameless` false, a program that is killed may leave a file that ends in .tmp. Nobody can have prepared
/// its name, which is drawn at random. Everything throws std::runtime_error naming the path.
class NewFile {
public:
    explicit NewFile(const std::string& path, bool mayBeNameless = true);
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile();

    void write(std::string_view bytes);

    /// For a process that writes the file instead, and gets it as its descriptor `there`: what it is to open.
    std::string nameFor(int there) const;
    int descriptor() const { return file_; }

    /// Gives the file its name.
    void complete();

private:
    [[noreturn]] void fail() const;

    std::string path_, temporary_;
    int file_ = -1;
    bool named_ = false;
};

}  // namespace aeolic
