#include <gtest/gtest.h>

/// Ends with 77 where every case was skipped, which CTest shows as skipped.
int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    const int result = RUN_ALL_TESTS();
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    const bool skipped = all.skipped_test_count() > 0 && all.successful_test_count() == 0;
    return result == 0 && skipped ? 77 : result;
}
