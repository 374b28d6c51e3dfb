#pragma once

#include <functional>
#include <string>

namespace aeolic {

/// Gets what libraries print in the reader while it reads the file `path`: lines that end with '\n', each handed over
/// once, when the reader has answered, refused or ended. Called by the thread that asked, perhaps by several at once.
/// What it throws is lost.
using ReaderWords = std::function<void(const std::string& path, const std::string& words)>;

/// From now on `hear` gets the words of all readers; empty: nobody, as at the start of a program. To be called while no
/// file is read.
void hearReaderWords(ReaderWords hear);

/// Hands words over. Never throws.
void tellReaderWords(const std::string& path, const std::string& words) noexcept;

}  // namespace aeolic
