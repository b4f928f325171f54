/// \file Two squares as a mesh file of every format, and what is read of such files or said of spoilt ones.
#pragma once

#include "mesh/quad_mesh.h"

#include <gtest/gtest.h>

#include <string>

namespace qm::testing {

[[nodiscard]] QuadMesh read(const std::string& text, const std::string& name);

/// What is said of bytes that must be refused.
[[nodiscard]] std::string refusal(const std::string& text, const std::string& name);

/// A message contains all the parts, begins with one that has '^' before it, and lacks those with '!'.
template <class... Parts>
[[nodiscard]] ::testing::AssertionResult says(const std::string& message, const Parts&... parts) {
    for (const std::string& part : {std::string(parts)...}) {
        const bool fits = part.starts_with('^')   ? message.starts_with(part.substr(1))
                          : part.starts_with('!') ? message.find(part.substr(1)) == std::string::npos
                                                  : message.find(part) != std::string::npos;
        if (!fits)
            return ::testing::AssertionFailure() << '"' << message << "\" does not fit \"" << part << '"';
    }
    return ::testing::AssertionSuccess();
}

/// Two squares side by side.
[[nodiscard]] std::string twoObj();
[[nodiscard]] std::string twoOff();
[[nodiscard]] std::string twoPlyHeader();
[[nodiscard]] std::string twoPly();
/// In binary PLY, with whatever else a file may hold.
/// \param coordinate, index  types, as PLY names them
[[nodiscard]] std::string binaryPly(bool little, const std::string& coordinate, const std::string& index,
                                    bool extras);

void expectTwoSquares(const std::string& text, const std::string& name);

/// \param what  every occurrence is replaced
[[nodiscard]] std::string replaced(std::string text, const std::string& what, const std::string& by);

} // namespace qm::testing
