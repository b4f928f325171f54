/// \file Which planes are given up where they spoil patches.
#include "bspline/fitting/verified_flattening.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {
namespace {

/// Five patches in a row, with a plane where marked.
class Row {
public:
    explicit Row(const std::vector<bool>& isPlane) : planes_(isPlane.size()) {
        for (std::size_t k = 0; k < isPlane.size(); ++k) {
            if (isPlane[k]) planes_[k] = FlatPatch{};
            if (k == 0) continue;
            Stretch stretch;
            stretch.sides[0].patch = k - 1;
            stretch.sides[1].patch = k;
            stretches_.push_back(stretch);
        }
    }

    bool drop(const std::vector<bool>& isSpoiled) { return dropPlanes(stretches_, isSpoiled, planes_); }

    [[nodiscard]] std::vector<bool> planes() const {
        std::vector<bool> result;
        for (const auto& plane : planes_)
            result.push_back(plane.has_value());
        return result;
    }

private:
    std::vector<Stretch> stretches_;
    std::vector<std::optional<FlatPatch>> planes_;
};

TEST(DropPlanes, KeepsAllWhereNothingIsSpoiled) {
    Row row({true, true, false, false, true});
    EXPECT_FALSE(row.drop({false, false, false, false, false}));
    EXPECT_EQ(row.planes(), (std::vector<bool>{true, true, false, false, true}));
}

TEST(DropPlanes, BeginsWithThoseOfTheSpoiledPatches) {
    Row row({true, true, true, true, true});
    EXPECT_TRUE(row.drop({false, true, false, false, false}));
    EXPECT_EQ(row.planes(), (std::vector<bool>{true, false, true, true, true}));
}

TEST(DropPlanes, TakesTheNearestIfTheSpoiledPatchesHaveNone) {
    Row row({false, false, true, false, true});
    EXPECT_TRUE(row.drop({true, false, false, false, false}));
    EXPECT_EQ(row.planes(), (std::vector<bool>{false, false, false, false, true}));
}

TEST(DropPlanes, LeavesPlanesThatCannotBeToBlame) {
    Row row({false, false, false, true, true});
    EXPECT_TRUE(row.drop({true, false, false, false, false}));
    EXPECT_EQ(row.planes(), (std::vector<bool>{false, false, false, true, true})) << "three patches away";
}

} // namespace
} // namespace qm
