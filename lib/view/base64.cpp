#include "base/at.h"
#include "view/number_bytes.h"

#include <openssl/evp.h>

namespace qm {

std::string base64(std::string_view bytes) {
    // In pieces, as OpenSSL counts in int; a multiple of 3 bytes needs no padding.
    constexpr std::size_t piece = 3 << 20;
    std::string text;
    text.reserve(bytes.size() / 3 * 4 + 8);
    for (std::size_t begin = 0; begin < bytes.size(); begin += piece) {
        const std::string_view part = bytes.substr(begin, piece);
        const std::size_t end = text.size();
        text.resize(end + (part.size() + 2) / 3 * 4 + 1); // one more for a closing zero
        const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data() + end),
                                           reinterpret_cast<const unsigned char*>(part.data()),
                                           static_cast<int>(part.size()));
        text.resize(end + at(length));
    }
    return text;
}

} // namespace qm
