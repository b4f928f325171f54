/// \file Scenes as the page's script reads them: JSON, with arrays of numbers in base64.
#pragma once

#include "view/page.h"

#include <span>
#include <string>

namespace qm {

/// Holds no "<", so that it may stand inside an element of a page.
[[nodiscard]] std::string sceneJson(std::span<const Scene> scenes, const PageOptions& options);

} // namespace qm
