#pragma once

#include <stdexcept>

namespace aeolic::stream {

/// A message is damaged, hostile or of another version. One line, for logs: it holds nothing of the bytes
/// themselves. Who sent them is not to be trusted further.
class ProtocolError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace aeolic::stream
