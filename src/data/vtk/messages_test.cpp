#include "data/vtk/messages.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPolyData.h>

#include <thread>

namespace aeolic {
namespace {

void complain(const char* what)
{
    vtkNew<vtkPolyData> object;
    vtkErrorWithObjectMacro(object, << what);
}

TEST(VtkMessages, TheFirstErrorIsOneLine)
{
    const VtkMessages messages;
    EXPECT_FALSE(messages.failed());
    complain("first\nof two lines.");
    complain("second");
    EXPECT_EQ(messages.firstError(), "first of two lines");
}

TEST(VtkMessages, TheInnermostScopeOfAThreadGetsIt)
{
    const VtkMessages outer;
    {
        const VtkMessages inner;
        complain("inner");
        EXPECT_EQ(inner.firstError(), "inner");
    }
    EXPECT_FALSE(outer.failed());
    complain("outer");
    EXPECT_EQ(outer.firstError(), "outer");
}

TEST(VtkMessages, AnotherThreadsScopeKeepsItsOwn)
{
    const VtkMessages mine;
    std::thread([] {
        const VtkMessages theirs;
        complain("theirs");
        EXPECT_EQ(theirs.firstError(), "theirs");
    }).join();
    EXPECT_FALSE(mine.failed());
}

TEST(VtkMessages, WhatAFiltersOwnThreadSaysIsNotLost)
{
    const VtkMessages mine;
    std::thread([] { complain("from a thread without a scope"); }).join();
    EXPECT_EQ(mine.firstError(), "from a thread without a scope");
}

}  // namespace
}  // namespace aeolic
