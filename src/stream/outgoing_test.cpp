#include "stream/outgoing.h"

#include <gtest/gtest.h>

namespace aeolic::stream {
namespace {

WireMessage tileOf(std::uint32_t frame)
{
    ByteVector message = beginMessage(MessageType::tile);
    putTileHeader(message, {frame, 0, 1, 1, 0, 0, 3, 0});
    putText(message, "pixels");
    return endMessage(std::move(message));
}

const WireMessage notice = jsonMessage(MessageType::notice, R"({"level":"info"})");

TEST(Outgoing, MessagesLeaveInTheOrderTheyCame)
{
    Outgoing queue;
    EXPECT_TRUE(queue.empty());
    const WireMessage first = tileOf(3);
    queue.push(first);
    queue.push(notice);
    EXPECT_EQ(queue.front(), first);
    queue.pop();
    EXPECT_EQ(queue.front(), notice);
    queue.pop();
    EXPECT_TRUE(queue.empty());
}

TEST(Outgoing, AFrameIsThereUntilItsLastMessageHasLeft)
{
    Outgoing queue;
    queue.push(frameMessage({7, 1, 1, 4, 4, 4, true}));
    queue.push(tileOf(7));
    queue.push(frameEndMessage(7, "{}"));
    for (int left = 3; left > 0; --left) {
        EXPECT_EQ(queue.frames(), 1) << left;
        EXPECT_TRUE(queue.has(7)) << left;
        EXPECT_FALSE(queue.has(8)) << left;
        queue.pop();
    }
    EXPECT_EQ(queue.frames(), 0);
    EXPECT_FALSE(queue.has(7));
}

TEST(Outgoing, AFrameThatWasGivenUpCountsToo)
{
    Outgoing queue;
    queue.push(tileOf(1));  // Its end never comes.
    queue.push(tileOf(2));
    queue.push(frameEndMessage(2, "{}"));
    EXPECT_EQ(queue.frames(), 2);
    queue.pop();
    EXPECT_EQ(queue.frames(), 1);
}

TEST(Outgoing, WhatBelongsToNoFrameIsCountedInBytes)
{
    Outgoing queue;
    queue.push(notice);
    queue.push(tileOf(1));
    queue.push(notice);
    EXPECT_EQ(queue.otherBytes(), 2 * notice->size());
    EXPECT_EQ(queue.frames(), 1);
    queue.pop();
    queue.pop();
    EXPECT_EQ(queue.otherBytes(), notice->size());
    queue.pop();
    EXPECT_EQ(queue.otherBytes(), 0u);
}

}  // namespace
}  // namespace aeolic::stream
