#pragma once

/// HDF5 files for the tests, by the HDF5 library; compiled into the tests only.

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <vector>

namespace aeolic::test {

/// How the library lays a data set out.
struct Hdf5SampleLayout {
    std::vector<std::uint64_t> chunk = {};  ///< Empty: in one piece.
    std::vector<std::uint64_t> most = {};   ///< As large as it may become; empty: as large as it is.
    bool compact = false, deflate = false, shuffle = false, checksum = false, early = false;
};

/// A file that is being written. The library's calls end the test where they fail.
class Hdf5Writer {
public:
    /// `newest`: in the newest forms that the library knows, else in the oldest.
    explicit Hdf5Writer(const std::string& path, bool newest = false, std::uint64_t userBytes = 0);
    ~Hdf5Writer();
    Hdf5Writer(const Hdf5Writer&) = delete;
    Hdf5Writer& operator=(const Hdf5Writer&) = delete;

    hid_t file() const { return file_; }

    /// Makes a group, and those above it. `ordered`: the file says in which order its links were made.
    void group(const std::string& path, bool ordered = false);

    void softLink(const std::string& path, const std::string& target);

    template <class Number>
    void data(const std::string& path, const std::vector<std::uint64_t>& shape, const std::vector<Number>& values,
              const Hdf5SampleLayout& layout = {}, hid_t fileType = H5I_INVALID_HID);

    template <class Number>
    void attribute(const std::string& path, const std::string& name, const std::vector<Number>& values);
    /// `bytes`: of a text of fixed length; 0: of the text's own.
    void text(const std::string& path, const std::string& name, const std::string& value, std::size_t bytes = 0);
    void variableText(const std::string& path, const std::string& name, const std::string& value);

private:
    hid_t file_;
};

/// Puts other numbers in the place of a data set.
template <class Number>
void replaceHdf5(const std::string& file, const std::string& path, const std::vector<std::uint64_t>& shape,
                 const std::vector<Number>& values);
void setHdf5Text(const std::string& file, const std::string& path, const std::string& attribute,
                 const std::string& value);
void removeHdf5(const std::string& file, const std::string& path);

/// Writes a file's groups, attributes of text and data sets of numbers again in HDF5's oldest form, where nothing has a
/// checksum.
void copyInOldForm(const std::string& from, const std::string& to);

}  // namespace aeolic::test
