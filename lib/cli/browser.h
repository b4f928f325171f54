/// \file Pictures of pages, taken by a headless Chromium where there is one.
#pragma once

#include <string>
#include <string_view>

namespace qm {

/// A PNG picture of a page as it looks once it is loaded.
/// \param width, height  in pixels
/// \throw Error  if no browser is installed, or it makes no picture
[[nodiscard]] std::string photographPage(std::string_view page, int width, int height);

} // namespace qm
