#pragma once

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace aeolic {

/// A legacy VTK file in memory, word for word and array for array. No count is believed before it was compared with the
/// bytes that are left. Every function throws InputError, which begins with the file's name.
class LegacyText {
public:
    /// Reads the file and its first three lines.
    explicit LegacyText(const std::string& path);

    const std::string& path() const { return path_; }

    /// The next word in upper case; empty at the end of the file.
    std::string keyword();
    /// The next word as it is written. Throws at the end of the file.
    std::string word(const char* what);
    /// A name, in which %20 stands for a blank.
    std::string name();
    std::int64_t wholeNumber(const char* what);
    /// A whole number from 0 to `most`.
    std::int64_t count(const char* what, std::int64_t most = std::int64_t{1} << 40);
    double number(const char* what);
    /// Whether the next word is `expected`, in upper case, which is then taken.
    bool takes(const std::string& expected);
    void skipLine();
    /// Up to and with the next line without a word.
    void skipToBlankLine();

    /// Values of a type as the file names it. Text (string, variant) is skipped and gives null.
    vtkSmartPointer<vtkDataArray> array(const std::string& type, std::int64_t tuples, std::int64_t components,
                                        const std::string& label);
    /// The bytes that colours take in a binary file, or numbers from 0 to 1 in text.
    vtkSmartPointer<vtkDataArray> colors(std::int64_t tuples, std::int64_t components, const std::string& label);

    bool atEnd();
    double share() const { return double(at_) / double(text_.size() + 1); }

private:
    std::string_view next();
    void skipStrings(std::int64_t count, const std::string& label);
    void requireBytes(double bytes, const std::string& label, std::int64_t values) const;
    [[noreturn]] void failWord(std::string_view found, const std::string& expected) const;
    void readText(vtkDataArray& values, const std::string& label);
    void readBinary(vtkDataArray& values);

    std::string path_, text_;
    std::size_t at_ = 0;
    bool binary_ = false;
};

}  // namespace aeolic
