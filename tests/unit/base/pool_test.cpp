#include "base/parallel.h"
#include "base/pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>

namespace qm {
namespace {

struct Workbench {
    explicit Workbench(std::atomic<int>& made) { ++made; }
    std::atomic<bool> isUsed = false;
};

TEST(Pool, MakesNoMoreObjectsThanThreadsUse) {
    std::atomic<int> made = 0;
    Pool<Workbench> pool([&] { return std::make_unique<Workbench>(made); });
    for (int k = 0; k < 10; ++k)
        EXPECT_EQ(pool.use([&](const Workbench&) { return k; }), k);
    EXPECT_EQ(made, 1);
    std::atomic<int> shared = 0;
    parallelFor(1000, 4, [&](std::size_t) {
        pool.use([&](Workbench& bench) {
            shared += bench.isUsed.exchange(true) ? 1 : 0;
            bench.isUsed = false;
        });
    });
    EXPECT_EQ(shared, 0);
    EXPECT_LE(made, 4);
}

TEST(Pool, TakesObjectsBackAfterAFault) {
    std::atomic<int> made = 0;
    Pool<Workbench> pool([&] { return std::make_unique<Workbench>(made); });
    EXPECT_THROW(pool.use([](Workbench&) { throw std::runtime_error("broken"); }), std::runtime_error);
    pool.use([](const Workbench&) {});
    EXPECT_EQ(made, 1);
}

} // namespace
} // namespace qm
