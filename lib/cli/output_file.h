/// \file Output that appears whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace qm {

/// A file that is written beside its final place and moved there by `commit`; if that is never called,
/// nothing remains, not even after a signal. Standard output ("-") and what is no regular file, such as a
/// device or a named pipe, is written directly. What was there before keeps its permissions; links are
/// followed.
class OutputFile {
public:
    /// \throw FileError  if it cannot be written
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view bytes);
    void commit();

private:
    void openBeside();
    void flush();
    void discard() noexcept;
    [[noreturn]] void fail();

    std::string name_;      ///< for messages
    std::string target_;    ///< where it will be; empty if it is written directly
    std::string temporary_; ///< where it is meanwhile
    std::string buffer_;
    int descriptor_ = -1;
};

/// From now on no output takes the place of this file, by whatever name or link: the result refers to it.
/// \param path  "-" is the file that standard input comes from, if any
void protectFromOutput(const std::string& path);

/// Fails now, with the message that would come at the end, if the path cannot become a file. Creates nothing.
void verifyWritable(const std::string& path);

/// Writes a whole file.
void writeFile(const std::string& path, std::string_view bytes);

} // namespace qm
