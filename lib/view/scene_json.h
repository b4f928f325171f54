/// \file A scene as the page's script reads it: JSON, with arrays of numbers in base64.
#pragma once

#include "view/page.h"

#include <string>

namespace qm {

/// Holds no "<", so that it may stand inside an element of a page.
[[nodiscard]] std::string sceneJson(const Scene& scene, const PageOptions& options);

} // namespace qm
