/// \file Reading whole files, and errors that name the file they are about.
#pragma once

#include "base/error.h"

#include <string>

namespace qm {

/// The text reads `file: place: what. remedy`. A tool puts nothing but its own name in front.
class FileError : public Error {
public:
    FileError(const std::string& file, const std::string& what, const std::string& remedy = {})
        : Error(file, what, remedy) {}
};

/// Calls f; an Error that names no file gets this one.
template <class Function> decltype(auto) inFile(const std::string& file, Function&& f) {
    try {
        return f();
    } catch (const FileError&) {
        throw;
    } catch (const Error& error) {
        throw FileError(file, error.what());
    }
}

/// False of folders, pipes and devices, and of what is not there.
[[nodiscard]] bool isRegularFile(const std::string& path);

/// The bytes of a file; "-" is standard input.
/// \throw FileError  if it cannot be read, is a folder or a device, or larger than any document or mesh can be
[[nodiscard]] std::string readFile(const std::string& path);

/// How messages call a file: its path, or "standard input".
[[nodiscard]] std::string displayName(const std::string& path);

} // namespace qm
