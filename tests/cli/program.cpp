// SPDX-License-Identifier: Apache-2.0
#include "program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace sundog::tests {
namespace {

std::filesystem::path temporary_file() {
    std::string name = (std::filesystem::temp_directory_path() / "sundog-cli-XXXXXX").string();
    const int descriptor = mkstemp(name.data());
    if (descriptor < 0) throw std::runtime_error("no temporary file");
    close(descriptor);
    return name;
}

void redirect(int descriptor, const char* file, int flags) {
    const int opened = open(file, flags);
    if (opened >= 0) dup2(opened, descriptor);
}

}  // namespace

std::filesystem::path built_program() { return SUNDOG_PROGRAM; }

Program::Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                 const std::filesystem::path& program, const std::filesystem::path& input)
    : out_(temporary_file()), err_(temporary_file()) {
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_ = fork();
    if (pid_ != 0) return;
    redirect(STDIN_FILENO, input.c_str(), O_RDONLY);
    redirect(STDOUT_FILENO, out_.c_str(), O_WRONLY | O_TRUNC);
    redirect(STDERR_FILENO, err_.c_str(), O_WRONLY | O_TRUNC);
    if (chdir(folder.c_str()) == 0) execv(argv[0], argv.data());
    _exit(127);
}

Program::~Program() {
    if (pid_ > 0) {
        kill(pid_, SIGKILL);
        wait();
    }
    std::filesystem::remove(out_);
    std::filesystem::remove(err_);
}

Outcome Program::wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_bytes(out_), read_bytes(err_)};
}

Outcome run(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
            const std::filesystem::path& program) {
    return Program(arguments, folder, program).wait();
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "sundog-cli-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string read_bytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

std::string table_scene() { return SUNDOG_SOURCE_DIR "/scenes/table/table.scene"; }

}  // namespace sundog::tests
