#include "cut/bucket_queue.h"

#include <gtest/gtest.h>

#include <queue>
#include <random>

namespace qm::test {
namespace {

TEST(BucketQueue, HasTheOrderOfAHeapWhateverItsSteps) {
    for (const double step : {0.0, 1e-9, 0.03, 1.0, 1e9}) {
        std::mt19937 random(7);
        BucketQueue queue(step);
        std::priority_queue<BucketQueue::Entry, std::vector<BucketQueue::Entry>, std::greater<>> heap;
        for (int use = 0; use < 2; ++use) { // an empty queue can be used again
            const auto put = [&](double distance) {
                const BucketQueue::Entry entry{distance, static_cast<int>(random() % 100),
                                               static_cast<int>(random() % 9)};
                queue.push(entry);
                heap.push(entry);
            };
            put(0);
            for (int k = 0; k < 5000 && !queue.empty(); ++k) {
                const BucketQueue::Entry entry = queue.pop();
                ASSERT_EQ(entry.distance, heap.top().distance);
                ASSERT_EQ(entry.rank, heap.top().rank);
                heap.pop();
                // Includes ties, skipped steps, and sometimes an entry nearer than those taken already.
                for (auto n = k < 4000 ? random() % 3 : 0; n > 0; --n)
                    put(std::max(0.0, entry.distance +
                                          static_cast<double>(static_cast<int>(random() % 50) - 5) / 100));
            }
            while (!queue.empty()) {
                ASSERT_EQ(queue.pop().distance, heap.top().distance);
                heap.pop();
            }
            EXPECT_TRUE(heap.empty());
        }
    }
}

} // namespace
} // namespace qm::test
