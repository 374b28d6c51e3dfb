#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace aeolic {

/// The name of the file itself or of its gzipped form, whichever is there; empty where neither is.
std::string foamFileOf(const std::string& path);

/// An OpenFOAM file, text or binary, plain or gzipped, read from its beginning to its end. Lists are read in pieces, so
/// that a wrong count never takes memory. Every failure is an InputError that begins with the file's name.
class FoamStream {
public:
    /// Opens `path`, or `path`.gz, and reads the header.
    explicit FoamStream(const std::string& path);
    ~FoamStream();

    const std::string& path() const { return path_; }
    const std::string& className() const { return class_; }  ///< "volVectorField", "faceCompactList" …

    bool longLabels() const { return labelBytes_ == 8; }  ///< 64 bits in binary lists, else 32.
    bool longScalars() const { return scalarBytes_ == 8; }

    /// The next word, number, quoted text (without the quotes) or single sign; empty at the end of the file.
    std::string token();
    std::string peekToken();
    bool quoted() const { return quoted_; }  ///< Whether the last token read was a quoted text.

    /// Throws unless the next token is `sign`. `item`: names the item that is read, for the message.
    void expect(std::string_view sign, const std::string& item);

    /// A whole number, and one that is not negative.
    std::int64_t label(const std::string& item);
    std::uint64_t count(const std::string& item);
    double scalar(const std::string& item);

    /// A list's values, `components` numbers each, as they stand behind the list's type. take(index, values) gets each.
    /// Returns how many there were.
    using TakeValues = std::function<void(std::uint64_t, const double*)>;
    std::uint64_t values(int components, const std::string& item, const TakeValues& take);
    using TakeLabel = std::function<void(std::uint64_t, std::int64_t)>;
    std::uint64_t labels(const std::string& item, const TakeLabel& take);

    /// Passes over an entry up to its ';', or over a dictionary with its braces.
    void skipEntry(const std::string& item);

    /// Reads on to the end: a file that is cut off behind the wanted values is refused, too.
    void finish();

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

private:
    struct File;

    int get();
    int peek();
    void skipBlank();
    void bytes(void* to, std::size_t size);
    void readHeader();
    void takeArch(const std::string& arch);
    template <class Parse, class Take>
    std::uint64_t list(std::size_t valueBytes, const std::string& item, const Parse& parse, const Take& take);

    std::string path_, class_, kept_;
    bool binary_ = false, hasKept_ = false, quoted_ = false;
    std::size_t labelBytes_ = 4, scalarBytes_ = 8;
    std::unique_ptr<File> file_;
};

/// How many numbers a value of a type has: "vector" 3, "scalar" 1 …; 0 where the type is not known.
int foamComponents(std::string_view type);

}  // namespace aeolic
