#include "document/json/utf8.h"

#include "base/error.h"

#include <cstddef>
#include <cstdint>

namespace qm {

bool isUtf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
        const unsigned first = byte(i++);
        if (first < 0x80) continue;
        const std::size_t rest = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
        if (first < 0xC2 || first > 0xF4 || i + rest > text.size()) return false;
        std::uint32_t code = first & (0x3FU >> rest);
        for (std::size_t k = 0; k < rest; ++k, ++i) {
            if ((byte(i) & 0xC0U) != 0x80) return false;
            code = code << 6 | (byte(i) & 0x3FU);
        }
        const bool overlong = (rest == 2 && code < 0x800) || (rest == 3 && code < 0x10000);
        const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
        if (overlong || surrogate || code > 0x10FFFF) return false;
    }
    return true;
}

void requireUtf8Name(const std::string& path) {
    if (!isUtf8(path))
        throw Error("", "its name is not UTF-8, so no document can refer to it", "Rename the file");
}

} // namespace qm
