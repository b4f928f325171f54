/// \file A scene as one self-contained HTML page.
#pragma once

#include "view/scene.h"

#include <array>
#include <string>
#include <vector>

namespace qm {

struct PageOptions {
    std::vector<std::string> shown; ///< names of the layers that are on at first; empty: what suits the kind
    std::array<double, 3> from{1, -1.5, 0.9}; ///< where one looks from, seen from the centre
    std::array<double, 3> up{0, 0, 1};
    bool still = false; ///< for a picture: nothing to operate
};

/// Needs no network and no other file. The same scene and options give the same bytes.
/// \throw Error  if a layer that is to be shown does not exist, or two of them colour the faces
[[nodiscard]] std::string printPage(const Scene& scene, const PageOptions& options);

} // namespace qm
