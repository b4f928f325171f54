/// \file Two squares as mesh files of every format, and checks of what is read from them or of error
/// messages.
#pragma once

#include "mesh/quad_mesh.h"

#include <gtest/gtest.h>

#include <string>

namespace qm::test {

[[nodiscard]] QuadMesh read(const std::string& text, const std::string& name);

/// The error message for bytes that must be refused.
[[nodiscard]] std::string refusal(const std::string& text, const std::string& name);

/// Whether a message contains all parts, begins with the part after a '^', and lacks the parts after a '!'.
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
/// The squares in binary PLY; with `extras`, together with everything else that a file may contain.
/// \param coordinate, index  types, in PLY's names
[[nodiscard]] std::string binaryPly(bool little, const std::string& coordinate, const std::string& index,
                                    bool extras);

void expectTwoSquares(const std::string& text, const std::string& name);

/// \param what  replaced wherever it occurs
[[nodiscard]] std::string replaced(std::string text, const std::string& what, const std::string& by);

} // namespace qm::test
