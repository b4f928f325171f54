/// \file The one exception of the library, for errors that the user can understand and mend.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

namespace qm {

/// Bad input or an impossible request. The text reads `place: what. remedy`; the tool that catches it puts
/// its own name and the file in front. Any other exception is a fault of the program.
class Error : public std::runtime_error {
public:
    /// \param place   where the error is: "line 12", "face 7", a JSON pointer; may be empty
    /// \param what    what is wrong, lower case, without a full stop
    /// \param remedy  what the user can do about it, a sentence without a full stop; may be empty
    Error(const std::string& place, const std::string& what, const std::string& remedy = {})
        : std::runtime_error(withoutZeros((place.empty() ? "" : place + ": ") + what +
                                          (remedy.empty() ? "" : ". " + remedy))) {}

private:
    /// Text of a document may hold zero bytes, and `what` would end there.
    static std::string withoutZeros(std::string text) {
        std::ranges::replace(text, '\0', '?');
        return text;
    }
};

} // namespace qm
