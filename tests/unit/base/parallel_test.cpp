#include "base/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace qm {
namespace {

TEST(ParallelFor, CallsEveryIndexOnce) {
    for (const unsigned jobs : {0U, 1U, 2U, 7U}) {
        std::vector<int> calls(1000, 0);
        parallelFor(calls.size(), jobs, [&](std::size_t k) { ++calls[k]; });
        EXPECT_EQ(calls, std::vector<int>(1000, 1)) << jobs << " jobs";
    }
}

TEST(ParallelFor, DoesNothingForNothing) {
    parallelFor(0, 4, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, PassesExceptionsOn) {
    for (const unsigned jobs : {1U, 3U}) {
        try {
            parallelFor(100, jobs, [](std::size_t k) {
                if (k == 40) throw std::runtime_error(std::to_string(k));
            });
            FAIL() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "40");
        }
    }
}

TEST(ParallelFor, ReportsTheFirstOfSeveralFailures) {
    for (int repeats = 0; repeats < 2000; ++repeats)
        try {
            parallelFor(16, 4, [](std::size_t k) {
                if (k >= 3) throw std::runtime_error(std::to_string(k));
            });
            FAIL() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            ASSERT_STREQ(error.what(), "3");
        }
}

TEST(Ahead, IsDoneWhenItHasBeenWaitedFor) {
    for (const unsigned jobs : {1U, 2U}) {
        int done = 0;
        Ahead work(jobs, [&] { ++done; });
        work.wait();
        work.wait();
        EXPECT_EQ(done, 1) << jobs << " jobs";
    }
}

TEST(Ahead, PassesAnExceptionOn) {
    for (const unsigned jobs : {1U, 2U}) {
        Ahead work(jobs, [] { throw std::runtime_error("fault"); });
        EXPECT_THROW(work.wait(), std::runtime_error);
    }
}

} // namespace
} // namespace qm
