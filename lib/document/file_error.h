/// \file An error that names the file it is about.
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

} // namespace qm
