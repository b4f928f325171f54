/// \file Files are written whole or not at all, and read whole.
#include "cli/system/output_file.h"
#include "document/files/files.h"
#include "support/message_of.h"
#include "support/sample_document.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <memory>

namespace {

namespace files = std::filesystem;
using qm::OutputFile;
using qm::test::messageOf;
using qm::test::TemporaryFolder;

std::size_t entries(const TemporaryFolder& folder) {
    const files::directory_iterator all(folder.file(""));
    return static_cast<std::size_t>(std::distance(files::begin(all), files::end(all)));
}

TEST(OutputFile, AppearsWholeOrNotAtAll) {
    const TemporaryFolder folder;
    const std::string path = folder.write("out", "as it was");
    {
        OutputFile file(path);
        file.write(std::string(1 << 20, 'x'));
        EXPECT_EQ(qm::readFile(path), "as it was");
    }
    EXPECT_EQ(qm::readFile(path), "as it was");
    EXPECT_EQ(entries(folder), 1U);
    OutputFile file(path);
    file.write("new ");
    file.write("text");
    file.commit();
    EXPECT_EQ(qm::readFile(path), "new text");
    EXPECT_EQ(entries(folder), 1U);
}

TEST(OutputFile, LeavesNothingWhereTooManyAreOpen) {
    const TemporaryFolder folder;
    {
        std::vector<std::unique_ptr<OutputFile>> open;
        const auto openAnother = [&] {
            open.push_back(std::make_unique<OutputFile>(folder.file("out" + std::to_string(open.size()))));
        };
        while (messageOf(openAnother).empty() && open.size() < 100) {
        }
        EXPECT_EQ(entries(folder), open.size());
        sigset_t blocked;
        pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
        EXPECT_EQ(sigismember(&blocked, SIGTERM), 0);
    }
    EXPECT_EQ(entries(folder), 0U);
}

TEST(OutputFile, FollowsLinksAndKeepsPermissions) {
    const TemporaryFolder folder;
    const std::string target = folder.write("target", "old");
    files::permissions(target,
                       files::perms::owner_read | files::perms::owner_write | files::perms::group_read);
    const auto before = files::status(target).permissions();
    files::create_symlink(target, folder.file("link"));
    qm::writeFile(folder.file("link"), "new");
    EXPECT_TRUE(files::is_symlink(folder.file("link")));
    EXPECT_EQ(qm::readFile(target), "new");
    EXPECT_EQ(files::status(target).permissions(), before);
}

TEST(OutputFile, FollowsLinksToWhatIsNotThereYet) {
    const TemporaryFolder folder;
    files::create_directory(folder.file("sub"));
    files::create_symlink("sub/second", folder.file("first"));
    files::create_symlink("target", folder.file("sub/second"));
    EXPECT_TRUE(qm::isSameFile(folder.file("first"), folder.file("sub/target")));
    qm::writeFile(folder.file("first"), "new");
    EXPECT_TRUE(files::is_symlink(folder.file("first")));
    EXPECT_TRUE(files::is_symlink(folder.file("sub/second")));
    EXPECT_EQ(qm::readFile(folder.file("sub/target")), "new");

    files::create_symlink("missing/target", folder.file("lost"));
    EXPECT_EQ(messageOf([&] { qm::verifyWritable(folder.file("lost")); }),
              folder.file("lost") + ": cannot be written: there is no folder " + folder.file("missing") +
                  ". Make it first");
    files::create_symlink("circle", folder.file("circle"));
    EXPECT_EQ(messageOf([&] { qm::verifyWritable(folder.file("circle")); }),
              folder.file("circle") + ": cannot be written: Too many levels of symbolic links");
    EXPECT_TRUE(files::is_symlink(folder.file("circle")));
}

TEST(OutputFile, WritesToDevices) {
    EXPECT_NO_THROW(qm::writeFile("/dev/null", "text"));
    const std::string message = messageOf([] { qm::writeFile("/dev/full", std::string(1 << 20, 'x')); });
    EXPECT_EQ(message, "/dev/full: cannot be written: No space left on device");
}

TEST(OutputFile, SaysEarlyThatAPathIsImpossible) {
    const TemporaryFolder folder;
    EXPECT_EQ(messageOf([&] { qm::verifyWritable(folder.file("missing/out")); }),
              folder.file("missing/out") + ": cannot be written: there is no folder " +
                  folder.file("missing") + ". Make it first");
    EXPECT_EQ(messageOf([&] { qm::verifyWritable(folder.file("")); }).find(folder.file("")), 0U);
    EXPECT_NO_THROW(qm::verifyWritable(folder.file("new")));
    EXPECT_EQ(entries(folder), 0U);
}

TEST(OutputFile, SparesWhatIsProtected) {
    const TemporaryFolder folder;
    const std::string mesh = folder.write("mesh", "as it was");
    files::create_symlink(mesh, folder.file("link"));
    files::create_directory(folder.file("sub"));
    qm::protectFromOutput(folder.file("sub/../mesh"), "is needed");
    for (const char* name : {"mesh", "link", "./mesh", "sub/../link"}) {
        EXPECT_EQ(messageOf([&] { qm::writeFile(folder.file(name), "new"); }),
                  folder.file(name) + ": is needed. Name another file");
    }
    EXPECT_EQ(qm::readFile(mesh), "as it was");
    EXPECT_NO_THROW(qm::writeFile(folder.file("other"), "new"));
}

TEST(OutputFile, IsTheSameByAnyName) {
    const TemporaryFolder folder;
    files::create_symlink(folder.write("file", ""), folder.file("link"));
    files::create_directory(folder.file("sub"));
    EXPECT_TRUE(qm::isSameFile(folder.file("link"), folder.file("file")));
    EXPECT_TRUE(qm::isSameFile(folder.file("new"), folder.file("sub/../new"))) << "neither exists";
    EXPECT_FALSE(qm::isSameFile(folder.file("new"), folder.file("file")));
    EXPECT_TRUE(qm::isSameFile("-", "-"));
    EXPECT_FALSE(qm::isSameFile("-", folder.file("file")));
}

TEST(ReadFile, NamesWhatCannotBeRead) {
    const TemporaryFolder folder;
    EXPECT_EQ(messageOf([&] { (void)qm::readFile(folder.file("none")); }),
              folder.file("none") + ": cannot be read: No such file or directory");
    EXPECT_EQ(messageOf([&] { (void)qm::readFile(folder.file("")); }),
              folder.file("") + ": is a folder. Name a file");
    const std::string bytes(300000, '\0');
    EXPECT_EQ(qm::readFile(folder.write("zeros", bytes)), bytes);
    EXPECT_EQ(qm::readFile(folder.write("empty", "")), "");
}

} // namespace
