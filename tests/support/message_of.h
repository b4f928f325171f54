/// \file What is said of a mistake.
#pragma once

#include "base/error.h"

#include <string>

namespace qm::test {

/// The message of what f throws; empty if it throws nothing.
template <class Thrown = Error, class Function> [[nodiscard]] std::string messageOf(Function&& f) {
    try {
        f();
    } catch (const Thrown& thrown) {
        return thrown.what();
    }
    return "";
}

} // namespace qm::test
