/// \file What a user may say about a page, as text.
#pragma once

#include "view/page.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace qm {

/// The layers of faces, and then those of lines and points.
[[nodiscard]] std::vector<std::string> allLayerNames();

/// "segments,borders" as a list, each once.
/// \throw Error  if there are no layers of such names, whatever the document
[[nodiscard]] std::vector<std::string> parseLayers(const std::string& text);

/// "1,-1.5,0.9" as a direction.
/// \throw Error  if it is not three numbers, or all are zero or so small or large that it comes to the same
[[nodiscard]] std::array<double, 3> parseDirection(const std::string& text);

/// "x", "y" or "z" with a share of the extent, such as "x:0.5"; empty: no section.
/// \throw Error  if it is neither
[[nodiscard]] std::optional<Section> parseSection(const std::string& text);

struct PictureSize {
    int width = 1200;
    int height = 900;
};

/// "1200x900".
/// \throw Error  if it is not two whole numbers from 16 to 8192
[[nodiscard]] PictureSize parseSize(const std::string& text);

} // namespace qm
