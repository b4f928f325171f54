/// \file Output files that appear complete or not at all.
#pragma once

#include <string>
#include <string_view>

namespace qm {

/// A file that is written beside its final place and moved there by `commit`; without that nothing remains,
/// even after a signal. Standard output ("-") and anything that is no regular file, such as a device or a
/// named pipe, is written directly. A replaced file keeps its permissions; links are followed.
class OutputFile {
public:
    /// \throw FileError  if the file cannot be written
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
    std::string target_;    ///< final place; empty if written directly
    std::string temporary_; ///< place before `commit`
    std::string buffer_;
    int descriptor_ = -1;
};

/// From now on no output may replace this file, by any name or link.
/// \param path  "-" stands for the file that standard input comes from, if any
/// \param what  why not, to complete a sentence that begins with the file: "is the input"
void protectFromOutput(const std::string& path, const std::string& what);

/// Whether two paths name one file, whether or not it exists yet.
[[nodiscard]] bool isSameFile(const std::string& one, const std::string& other);

/// Throws at once, with the message that would come at the end, if no file can be written at the path.
/// Creates nothing.
void verifyWritable(const std::string& path);

/// Writes a whole file.
void writeFile(const std::string& path, std::string_view bytes);

} // namespace qm
