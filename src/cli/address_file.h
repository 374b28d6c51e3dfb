#pragma once

#include <string>

namespace aeolic {

/// A file with the server's address and token, which only its owner may read. It is there while this object is.
class AddressFile {
public:
    /// Writes `text` to a new file of mode 0600 and puts it in the place of what was at `path`, be that a link or
    /// somebody's prepared file. Throws InputError naming the path.
    AddressFile(const std::string& path, const std::string& text);
    /// Removes the file, unless another server has put its own there.
    ~AddressFile();
    AddressFile(const AddressFile&) = delete;
    AddressFile& operator=(const AddressFile&) = delete;

private:
    std::string path_;
    unsigned long device_ = 0, inode_ = 0;
};

/// Where the address goes if the user has named no file: ~/.aeolic/HOST-PORT. Makes the folder. Throws InputError where
/// there is no home. `address` is http://HOST:PORT/… or https://…
std::string defaultAddressFile(const std::string& address);

}  // namespace aeolic
