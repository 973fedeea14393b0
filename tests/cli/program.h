// SPDX-License-Identifier: Apache-2.0
// Runs the built program and looks at what it says.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace sundog::tests {

struct Outcome {
    int status = -1;  ///< Exit status; -1 if a signal ended it.
    std::string out, err;
};

/// The program that was built.
std::filesystem::path built_program();

/// `sundog ARGUMENTS`, started in `folder` with its standard output and error in files.
class Program {
public:
    /// `program` may be another one, or a link to it. With `input`, standard input is that file.
    explicit Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder = ".",
                     const std::filesystem::path& program = built_program(),
                     const std::filesystem::path& input = "/dev/null");
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    /// Ends the program if it still runs.
    ~Program();
    [[nodiscard]] pid_t pid() const { return pid_; }
    /// Waits until it ends.
    Outcome wait();

private:
    std::filesystem::path out_, err_;
    pid_t pid_ = -1;
};

/// Runs to the end.
Outcome run(const std::vector<std::string>& arguments, const std::filesystem::path& folder = ".",
            const std::filesystem::path& program = built_program());

/// An empty folder that goes away with it.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string read_bytes(const std::filesystem::path& file);
void write_bytes(const std::filesystem::path& file, const std::string& bytes);

/// The gallery's first scene.
std::string table_scene();

}  // namespace sundog::tests
