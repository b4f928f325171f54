/// \file Reading whole files, and errors that name the file.
#pragma once

#include "base/error.h"

#include <string>

namespace qm {

/// An error whose text reads `file: place: what. remedy`. Tools put only their own name in front.
class FileError : public Error {
public:
    FileError(const std::string& file, const std::string& what, const std::string& remedy = {})
        : Error(file, what, remedy) {}
};

/// Calls f; an Error that names no file becomes a FileError of this file.
template <class Function> decltype(auto) inFile(const std::string& file, Function&& f) {
    try {
        return f();
    } catch (const FileError&) {
        throw;
    } catch (const Error& error) {
        throw FileError(file, error.what());
    }
}

/// False for folders, pipes and devices, and if there is no such file.
[[nodiscard]] bool isRegularFile(const std::string& path);

/// The bytes of a file; "-" is standard input.
/// \throw FileError  if it cannot be read, is a folder or a device, or is larger than any document or mesh
/// can be
[[nodiscard]] std::string readFile(const std::string& path);

/// The name of a file in messages: its path, or "standard input".
[[nodiscard]] std::string displayName(const std::string& path);

} // namespace qm
