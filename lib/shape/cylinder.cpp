#include "shape/sample_meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

constexpr double height = 3;
constexpr double core = 0.6; ///< from the axis to the corners of a cap's grid

/// The skin is one grid from the bottom's core over its rim and the wall to the top's core.
class Cylinder {
public:
    explicit Cylinder(int around)
        : columns_(around / 4), rows_(around / 2 - columns_), rings_(std::max(1, around / 12)),
          levels_(std::max(1, around / 2)), skin_{.columns = around,
                                                  .rows = 2 * rings_ + levels_,
                                                  .columnsClosed = true},
          halfAngle_(std::numbers::pi * columns_ / around) {}

    QuadList run() {
        list_ = skin_.withPoints([this](int column, int row) { return skinPoint(column, row); });
        addCore(0, 0);
        addCore(skin_.rows, height);
        return std::move(list_);
    }

private:
    [[nodiscard]] Point skinPoint(int column, int row) const {
        const int fromEnd = std::min(row, skin_.rows - row);
        if (fromEnd >= rings_) return onCircle(column, height * (row - rings_) / levels_);
        const double z = 2 * row < skin_.rows ? 0 : height;
        const double share = static_cast<double>(fromEnd) / rings_;
        return (1 - share) * onCore(column, z) + share * onCircle(column, z);
    }

    [[nodiscard]] Point onCircle(int column, double z) const {
        const double angle =
            2 * std::numbers::pi * column / skin_.columns - std::numbers::pi / 2 - halfAngle_;
        return {std::cos(angle), std::sin(angle), z};
    }

    /// The border of the core in the order of the columns.
    [[nodiscard]] Point onCore(int column, double z) const {
        if (column <= columns_) return inCore(column, 0, z);
        if (column <= columns_ + rows_) return inCore(columns_, column - columns_, z);
        if (column <= 2 * columns_ + rows_) return inCore(2 * columns_ + rows_ - column, rows_, z);
        return inCore(0, skin_.columns - column, z);
    }

    [[nodiscard]] Point inCore(int i, int j, double z) const {
        return {core * std::sin(halfAngle_) * (2.0 * i / columns_ - 1),
                core * std::cos(halfAngle_) * (2.0 * j / rows_ - 1), z};
    }

    void addCore(int skinRow, double z) {
        const int first = static_cast<int>(list_.points.size());
        for (int j = 1; j < rows_; ++j)
            for (int i = 1; i < columns_; ++i)
                list_.points.push_back(inCore(i, j, z));
        const auto vertex = [&](int i, int j) {
            if (j == 0) return skin_.vertex(i, skinRow);
            if (i == columns_) return skin_.vertex(columns_ + j, skinRow);
            if (j == rows_) return skin_.vertex(2 * columns_ + rows_ - i, skinRow);
            if (i == 0) return skin_.vertex(skin_.columns - j, skinRow);
            return first + (j - 1) * (columns_ - 1) + i - 1;
        };
        for (int j = 0; j < rows_; ++j)
            for (int i = 0; i < columns_; ++i) {
                std::array<int, 4> quad{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1),
                                        vertex(i, j + 1)};
                if (skinRow == 0) std::ranges::reverse(quad); // seen from below
                list_.quads.push_back(quad);
            }
    }

    int columns_; ///< quads of the core along x
    int rows_;    ///< and along y
    int rings_;   ///< between core and rim
    int levels_;
    GridTopology skin_;
    double halfAngle_; ///< that a side of the core along x is seen under
    QuadList list_;
};

} // namespace

QuadList cylinderShape(int around) {
    return Cylinder(around).run();
}

} // namespace qm
