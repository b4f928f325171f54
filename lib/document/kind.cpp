#include "document/kind.h"

#include "base/at.h"

#include <array>

namespace qm {

namespace {

struct KindEntry {
    const char* name;
    const char* section;
    const char* tool;
};

constexpr std::array<KindEntry, 6> entries{{{"basecomplex", "baseComplex", "qm-basecomplex"},
                                            {"features", "features", "qm-features"},
                                            {"cut", "cut", "qm-cut"},
                                            {"enumeration", "enumeration", "qm-enum"},
                                            {"layout", "layout", "qm-merge"},
                                            {"surfaces", "surfaces", "qm-bspline"}}};

const KindEntry& entryOf(Kind kind) {
    return entries[at(kind)];
}

} // namespace

std::string kindName(Kind kind) {
    return entryOf(kind).name;
}
const char* sectionOf(Kind kind) {
    return entryOf(kind).section;
}
const char* toolOf(Kind kind) {
    return entryOf(kind).tool;
}

std::optional<Kind> kindOfName(std::string_view name) {
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (name == entries.at(i).name) return static_cast<Kind>(i);
    return {};
}

} // namespace qm
