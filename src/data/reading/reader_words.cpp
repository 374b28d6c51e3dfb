#include "data/reading/reader_words.h"

#include <exception>
#include <utility>

namespace aeolic {
namespace {

ReaderWords& listener()
{
    static ReaderWords one;
    return one;
}

}  // namespace

void hearReaderWords(ReaderWords hear)
{
    listener() = std::move(hear);
}

void tellReaderWords(const std::string& path, const std::string& words) noexcept
{
    if (words.empty() || !listener()) return;
    try {
        listener()(path, words.back() == '\n' ? words : words + '\n');
    } catch (const std::exception&) {  // A file is read no worse because nobody could be told.
    }
}

}  // namespace aeolic
