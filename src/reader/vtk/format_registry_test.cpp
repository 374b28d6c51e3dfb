#include "reader/vtk/format_registry.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(FormatRegistry, OneWayOpensEachKindOfData)
{
    for (const FileKind& kind : fileKinds) {
        const FormatReader& row = formatOf(kind);
        const int ways = (row.openParts ? 1 : 0) + (row.open ? 1 : 0) + (row.makeReader ? 1 : 0) + (row.read ? 1 : 0);
        EXPECT_EQ(ways, kind.holdsData() ? 1 : 0) << kind.endings;
        EXPECT_TRUE(row.makeReader || !row.check) << kind.endings;
    }
}

/// Callers ask by what the kinds say, without a look at who answers.
TEST(FormatRegistry, WhatAKindCanBeAskedIsAnswered)
{
    for (const FileKind& kind : fileKinds) {
        const FormatReader& row = formatOf(kind);
        EXPECT_EQ(row.counts != nullptr, kind.has(kTellsCounts)) << kind.endings;
        EXPECT_EQ(row.times != nullptr, kind.has(kNamesFiles)) << kind.endings;
        EXPECT_EQ(row.pieces != nullptr, kind.pieces >= FilePieces::apart) << kind.endings;
        EXPECT_EQ(row.listed != nullptr, kind.use == FileUse::list) << kind.endings;
        EXPECT_TRUE(kind.has(kHasParts) || !row.openParts) << kind.endings;
    }
}

}  // namespace
}  // namespace aeolic
