// SPDX-License-Identifier: Apache-2.0
#include "output/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <memory>
#include <string>
#include <system_error>

#include "base/diagnostics.h"
#include "output/image.h"

namespace sundog::output {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestInput = std::uintmax_t{1} << 32;

std::string reason(int error) { return std::generic_category().message(error); }

/// A file descriptor that closes itself.
struct Descriptor {
    explicit Descriptor(int number_) : number(number_) {}
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number;
};

/// Writes all of `bytes`; the error number, or 0.
int write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

bool is_standard_output(const fs::path& file) { return file == "-" || file == "/dev/stdout"; }

void write_directly(const fs::path& file, std::string_view bytes) {
    int error = 0;
    if (is_standard_output(file)) {
        error = write_all(STDOUT_FILENO, bytes);
    } else {
        const Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
        error = out.number < 0 ? errno : write_all(out.number, bytes);
    }
    if (error != 0) fail_to_write(is_standard_output(file) ? "standard output" : file, reason(error));
}

}  // namespace

void fail_to_read(const fs::path& file, const std::string& why) {
    Diagnostic diagnostic;
    diagnostic.where.file = std::make_shared<const std::string>(file.string());
    diagnostic.message = why;
    throw InputError(std::move(diagnostic));
}

void fail_to_write(const fs::path& file, const std::string& why) {
    throw OutputError("can't write '" + file.string() + "': " + why);
}

std::vector<unsigned char> read_file(const fs::path& file) {
    // O_NONBLOCK: opening a pipe that nobody writes to would wait for ever.
    const Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat status {};
    if (in.number < 0 || ::fstat(in.number, &status) != 0) fail_to_read(file, "can't read the file: " + reason(errno));
    if (S_ISDIR(status.st_mode)) fail_to_read(file, "can't read the file: it is a folder");
    if (!S_ISREG(status.st_mode)) fail_to_read(file, "can't read the file: it is no regular file");
    const auto size = static_cast<std::uintmax_t>(status.st_size);
    if (size > kLargestInput) fail_to_read(file, "the file has over 4 GiB");
    std::vector<unsigned char> bytes(size);
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t got = ::read(in.number, bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail_to_read(file, "can't read the file: " + reason(errno));
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    bytes.resize(filled);
    return bytes;
}

bool is_special_file(const fs::path& file) {
    if (is_standard_output(file)) return true;
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

Replacement::Replacement(const fs::path& target) : named_(target), target_(target) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) fail_to_write(named_, "it is a folder");
    if (target.filename().empty()) fail_to_write(named_, "it names no file");
    if (fs::exists(status)) {
        if (!fs::is_regular_file(status)) fail_to_write(named_, "it is no regular file");
        target_ = fs::canonical(target, error);
        if (error) fail_to_write(named_, error.message());
        // Renaming would get past the protection of the file.
        if (::access(target_.c_str(), W_OK) != 0) fail_to_write(named_, reason(errno));
    }
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    static std::atomic<unsigned> count{0};
    for (int attempt = 0; attempt < 100 && descriptor_ < 0; ++attempt) {
        temporary_ = folder / (".sundog-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp");
        descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) {
        const int why = errno;
        if (why != ENOENT) fail_to_write(named_, reason(why));
        // /proc is a folder in which no file can be made, and says so by ENOENT as well.
        if (fs::is_directory(folder, error))
            fail_to_write(named_, "the folder '" + folder.string() + "' takes no files");
        fail_to_write(named_, "there is no folder '" + folder.string() + "'");
    }
    exists_ = true;
    if (fs::exists(status)) ::fchmod(descriptor_, static_cast<mode_t>(status.permissions()) & 0777U);
}

Replacement::~Replacement() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (exists_) ::unlink(temporary_.c_str());
}

void Replacement::write(std::string_view bytes) {
    if (const int error = write_all(descriptor_, bytes); error != 0) fail_to_write(named_, reason(error));
}

void Replacement::commit() {
    // Network file systems report a full disk only here.
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0 && errno != EINTR) fail_to_write(named_, reason(errno));
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail_to_write(named_, reason(errno));
    exists_ = false;
}

void write_file_atomically(const fs::path& file, std::string_view bytes) {
    if (is_special_file(file)) {
        write_directly(file, bytes);
        return;
    }
    Replacement replacement(file);
    replacement.write(bytes);
    replacement.commit();
}

}  // namespace sundog::output
