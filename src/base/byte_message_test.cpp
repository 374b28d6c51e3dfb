#include "base/byte_message.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace aeolic {
namespace {

TEST(ByteMessages, WhatIsWrittenIsRead)
{
    ByteWriter writer;
    writer.add(7);
    writer.add(std::vector<double>{1.5, -2});
    writer.add(std::string("größer"));
    writer.add(std::vector<std::string>{"", "b"});
    writer.add(std::vector<float>{});
    const Bytes bytes = writer.take();
    ByteReader reader(bytes);
    int number = 0;
    std::vector<double> values;
    std::string text;
    std::vector<std::string> texts;
    std::vector<float> none{1};
    reader.read(number);
    reader.read(values);
    reader.read(text);
    reader.read(texts);
    reader.read(none);
    EXPECT_EQ(number, 7);
    EXPECT_EQ(values, (std::vector<double>{1.5, -2}));
    EXPECT_EQ(text, "größer");
    EXPECT_EQ(texts, (std::vector<std::string>{"", "b"}));
    EXPECT_TRUE(none.empty() && reader.atEnd());
    ByteWriter huge;
    huge.add(~std::uint64_t{0});
    const Bytes wrong = huge.take();
    ByteReader refuses(wrong);
    EXPECT_THROW(refuses.read(values), std::runtime_error) << "a count that cannot be";
}

}  // namespace
}  // namespace aeolic
