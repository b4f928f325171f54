#include "cli/system/run_statistics.h"

#include <gtest/gtest.h>

namespace qm {
namespace {

TEST(RunStatistics, WholeNumbersHaveNoExponent) {
    RunStatistics statistics;
    statistics.count("faces", 200000);
    statistics.count("graphs", 1e25);
    statistics.count("gap", 0.25);
    EXPECT_NE(statistics.line("qm-enum").find(R"({"faces": 200000, "graphs": 1e+25, "gap": 0.25})"),
              std::string::npos)
        << statistics.line("qm-enum");
}

} // namespace
} // namespace qm
