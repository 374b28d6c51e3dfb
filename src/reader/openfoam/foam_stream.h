#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "reader/binary/numbers.h"

struct gzFile_s;

namespace aeolic {

/// A folder or file of a case. In the collated format processors have their files in common.
struct FoamPath {
    std::filesystem::path path;
    int block = -1;  ///< Which block of such a file is meant; -1: the file is no such file.

    FoamPath operator/(const std::string& name) const { return {path / name, block}; }
};

/// The name of the file itself or of its gzipped form, whichever is there; empty where neither is.
std::string foamFileOf(const FoamPath& file);

/// An OpenFOAM file, text or binary, plain or gzipped, read from its beginning to its end. Lists are read value by
/// value, so that a wrong count takes no memory. Every failure is an InputError that begins with the file's name.
class FoamStream {
public:
    /// Opens the file, or its gzipped form, and reads the header. Of a file of blocks the stream is the block, and the
    /// header that of the first one.
    explicit FoamStream(const FoamPath& file);
    ~FoamStream();

    const std::string& className() const { return class_; }  ///< "volVectorField", "faceCompactList" …

    /// The next word, number, quoted text (without the quotes) or single sign; empty at the end of the file.
    std::string token();
    std::string peekToken();
    bool quoted() const { return quoted_; }  ///< Whether the last token read was a quoted text.

    /// Throws unless the next token is `sign`. `item`: names the item that is read, for the message.
    void expect(std::string_view sign, const std::string& item);

    /// A whole number that is not negative.
    std::uint64_t count(const std::string& item);
    double scalar(const std::string& item);

    /// A list's values, `components` numbers each, as they stand behind the list's type. take(index, numbers) gets some
    /// at a time, from the index on; null: they are passed over. Returns how many values there were.
    using TakeValues = std::function<void(std::uint64_t, std::span<const double>)>;
    std::uint64_t values(int components, const std::string& item, const TakeValues& take);
    using TakeLabels = std::function<void(std::uint64_t, std::span<const std::int64_t>)>;
    std::uint64_t labels(const std::string& item, const TakeLabels& take);

    /// Passes over an entry up to its ';', or over a dictionary with its braces.
    void skipEntry(const std::string& item);

    /// Goes to the entry `name`. Throws where there is none.
    void goTo(const std::string& name, const std::string& expected);

    /// Reads on to the end: a file that is cut off behind the wanted values is refused, too.
    void finish();

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

private:
    struct Close {
        void operator()(gzFile_s* file) const;
    };

    int get();
    int peek();
    void skipBlank();
    void bytes(void* to, std::size_t size);
    void goToPlace(std::uint64_t place);
    void requireUndamaged() const;
    void readHeader();
    void enterBlock(int block);
    template <class Number>
    Number number(const std::string& item);
    template <class Number>
    std::uint64_t list(NumberType type, std::size_t components, const std::string& item,
                       const std::function<void(std::uint64_t, std::span<const Number>)>& take);

    static constexpr int kNone = -2;

    std::string path_, class_, kept_;
    bool binary_ = false, swapped_ = false, hasKept_ = false, quoted_ = false;
    NumberType labelType_ = NumberType::int32, scalarType_ = NumberType::float64;
    std::unique_ptr<gzFile_s, Close> file_;
    int next_ = kNone;         // What peek() has read.
    std::uint64_t place_ = 0;  // Bytes in front of what comes next.
    std::uint64_t end_ = std::numeric_limits<std::uint64_t>::max();
};

/// How many numbers a value of a type has: "vector" 3, "scalar" 1 …; 0 where the type is not known.
int foamComponents(std::string_view type);

}  // namespace aeolic
