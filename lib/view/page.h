/// \file Scenes as one self-contained HTML page.
#pragma once

#include "view/scene.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace qm {

/// The names of all layers that a scene may have: of faces, and of lines and points.
inline constexpr std::array faceLayerNames{"mesh",      "submeshes", "segments", "surfaces",
                                           "shaded",    "zebra",     "mean",     "gauss",
                                           "deviation", "tolerance", "scan",     "mesh-zebra"};
inline constexpr std::array lineLayerNames{"edges",   "separatrices",  "features", "cuts",     "graphs",
                                           "borders", "tracks",        "curves",   "jumps",    "net",
                                           "knots",   "extraordinary", "seeds",    "terminals"};

/// A plane that cuts the model open: what lies beyond it is left out.
struct Section {
    std::size_t axis = 0; ///< 0 to 2 for x to z
    double share = 0.5;   ///< of the extent along the axis
};

struct PageOptions {
    std::vector<std::string> shown; ///< names of the layers that are on at first; empty: what suits the kind
    std::array<double, 3> from{1, -1.5, 0.9}; ///< where one looks from, seen from the centre
    std::array<double, 3> up{0, 0, 1};
    std::optional<Section> section;
    bool still = false; ///< for a picture: nothing to operate
    bool key = true;    ///< a picture's: what colours and lines stand for
};

/// Needs no network and no other file. The same scenes and options give the same bytes.
/// \param scenes  one, or two side by side, seen by one camera
/// \throw Error  if a layer that is to be shown does not exist in any scene, or two of them colour the faces
[[nodiscard]] std::string printPage(std::span<const Scene> scenes, const PageOptions& options);

} // namespace qm
