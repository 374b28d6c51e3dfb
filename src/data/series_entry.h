#pragma once

#include <string>

#include "base/byte_message.h"

namespace aeolic {

/// A line of a list of files, as it stands there.
struct SeriesEntry {
    std::string file;
    double time = 0;
    long part = 0;  ///< Which of several files at the same time.
};

template <PerhapsConst<SeriesEntry> Entry, class Visit>
void withMembers(Entry& entry, const Visit& visit)
{
    visit(entry.file, entry.time, entry.part);
}

}  // namespace aeolic
