/// \file Conversion of numbers to text.
#include "base/number_text.h"

#include <gtest/gtest.h>

namespace {

using qm::numberText;

TEST(NumberText, IsTheShortestThatReadsBack) {
    EXPECT_EQ(numberText(0.1), "0.1");
    EXPECT_EQ(numberText(0.1F), "0.1");
    EXPECT_EQ(numberText(12345678), "12345678");
    EXPECT_EQ(numberText(2.0), "2");
    EXPECT_EQ(numberText(-0.0), "-0");
    EXPECT_EQ(numberText(qm::withoutSignOfZero(-0.0)), "0");
    EXPECT_EQ(numberText(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
    for (const double value : {-std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min(),
                               1.0 / 3, -1.2345678901234567e-300}) {
        double back = 0;
        EXPECT_TRUE(qm::parseNumber(numberText(value), back));
        EXPECT_EQ(back, value);
    }
}

TEST(NumberText, IsRoundedForPeople) {
    EXPECT_EQ(qm::roundedText(3.141592653589793), "3.14159");
    EXPECT_EQ(qm::roundedText(1e9), "1000000000");
    EXPECT_EQ(qm::roundedText(-180), "-180");
    EXPECT_EQ(qm::roundedText(1e300), "1e+300");
}

TEST(NumberText, IsReadWholeOrNotAtAll) {
    double real = 7;
    int whole = 7;
    for (const char* text : {"", " 1", "1 ", "1x", "0x10", "nan", "inf", "1e999", "1,5", "+1"})
        EXPECT_FALSE(qm::parseNumber(text, real)) << text;
    for (const char* text : {"", "1.5", "1e3", "99999999999"})
        EXPECT_FALSE(qm::parseNumber(text, whole)) << text;
    EXPECT_TRUE(qm::parseNumber("-2.5e1", real) && qm::parseNumber("-25", whole));
    EXPECT_EQ(real, -25);
    EXPECT_EQ(whole, -25);
}

} // namespace
