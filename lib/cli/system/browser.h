/// \file Pictures of pages, taken by a headless Chromium if one is installed.
#pragma once

#include <string>
#include <string_view>

namespace qm {

/// A PNG picture of a page after it has loaded.
/// \param width, height  in pixels
/// \throw Error  if no browser is installed, or if it takes no picture
[[nodiscard]] std::string photographPage(std::string_view page, int width, int height);

} // namespace qm
