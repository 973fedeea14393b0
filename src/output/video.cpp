// SPDX-License-Identifier: Apache-2.0
#include "output/video.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/diagnostics.h"
#include "output/file.h"

extern char** environ;

namespace sundog::output {
namespace {

namespace fs = std::filesystem;

std::string lower_case_ending(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

using Arguments = std::vector<std::string>;

/// How ffmpeg is to make a file of this kind.
Arguments coding_arguments(const std::string& ending) {
    // Our pictures are sRGB; players expect BT.709 and have to be told.
    const std::string to_bt709 = "scale=out_color_matrix=bt709:out_range=tv";
    const Arguments bt709{"-colorspace",  "bt709", "-color_primaries", "bt709",  "-color_trc", "iec61966-2-1",
                          "-color_range", "tv",    "-pix_fmt",         "yuv420p"};
    Arguments arguments;
    if (ending == ".mp4") {
        arguments = {"-vf", to_bt709, "-c:v", "libx264", "-crf", "18", "-movflags", "+faststart"};
        arguments.insert(arguments.end(), bt709.begin(), bt709.end());
        arguments.insert(arguments.end(), {"-f", "mp4"});
    } else if (ending == ".webm") {
        arguments = {"-vf",  to_bt709, "-c:v",    "libvpx-vp9", "-b:v",      "0",
                     "-crf", "24",     "-row-mt", "1",          "-cpu-used", "4"};
        arguments.insert(arguments.end(), bt709.begin(), bt709.end());
        arguments.insert(arguments.end(), {"-f", "webm"});
    } else {
        const std::string filter = std::string("split[frames][sample];[sample]palettegen=stats_mode=full[palette];") +
                                   "[frames][palette]paletteuse=dither=sierra2_4a:diff_mode=rectangle";
        arguments = {"-filter_complex", filter, "-loop", "0", "-f", "gif"};
    }
    return arguments;
}

/// Starts `arguments` (the program is found in PATH) with the descriptors as standard input and error.
/// The error number, or 0.
int start_program(const Arguments& arguments, int input, int errors, pid_t& process) {
    posix_spawn_file_actions_t actions{};
    posix_spawnattr_t attributes{};
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    // A group of its own: Ctrl-C is for us, who then finish the file with the frames there are.
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t signals{};
    ::sigemptyset(&signals);
    ::posix_spawnattr_setsigmask(&attributes, &signals);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ}) ::sigaddset(&signals, signal);
    ::posix_spawnattr_setsigdefault(&attributes, &signals);
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const int error = ::posix_spawnp(&process, argv[0], &actions, &attributes, argv.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    return error;
}

/// The last lines of a program's messages, at most about 600 characters.
std::string last_lines(std::FILE* messages) {
    constexpr long kMost = 600;
    std::fseek(messages, 0, SEEK_END);
    const long size = std::ftell(messages);
    std::fseek(messages, std::max(0L, size - kMost), SEEK_SET);
    std::string text(static_cast<std::size_t>(kMost), '\0');
    text.resize(std::fread(text.data(), 1, text.size(), messages));
    if (size > kMost) text.erase(0, text.find('\n') + 1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
    return text;
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }  // NOLINT(cppcoreguidelines-owning-memory)
};

}  // namespace

bool is_video(const fs::path& file) {
    const std::string ending = lower_case_ending(file);
    return ending == ".mp4" || ending == ".webm" || ending == ".gif";
}

struct VideoWriter::Impl {
    Impl(const fs::path& file_, int width_, int height_, double fps)
        : file(file_), width(width_), height(height_), replacement(file_) {
        const std::string ending = lower_case_ending(file);
        // H.264 with halved colour resolution has even sizes; the last column and row are repeated.
        const bool even = ending == ".mp4";
        coded_width = even ? (width + 1) / 2 * 2 : width;
        coded_height = even ? (height + 1) / 2 * 2 : height;
        std::array<char, 32> rate{};
        std::snprintf(rate.data(), rate.size(), "%.9g", fps);
        Arguments arguments{
            "ffmpeg",     "-nostdin",    "-hide_banner",
            "-loglevel",  "error",       "-y",
            "-f",         "rawvideo",    "-pixel_format",
            "rgb24",      "-video_size", std::to_string(coded_width) + "x" + std::to_string(coded_height),
            "-framerate", rate.data(),   "-i",
            "pipe:0",     "-an"};
        for (std::string& argument : coding_arguments(ending)) arguments.push_back(std::move(argument));
        // With the protocol's name, no file name can be taken for an option or another protocol.
        arguments.push_back("file:" + replacement.path().string());
        messages.reset(std::tmpfile());  // NOLINT(cppcoreguidelines-owning-memory)
        // A socket, as writing to one whose reader has gone can fail without raising SIGPIPE.
        std::array<int, 2> ends{-1, -1};
        if (messages == nullptr || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
            fail_to_write(file, std::generic_category().message(errno));
        ::fcntl(::fileno(messages.get()), F_SETFD, FD_CLOEXEC);
        socket = ends[0];
        const int error = start_program(arguments, ends[1], ::fileno(messages.get()), process);
        ::close(ends[1]);
        if (error == 0) return;
        process = -1;
        close_socket();
        if (error == ENOENT)
            fail_to_write(file,
                          "videos need the program ffmpeg, which is not installed; install it (on Debian: "
                          "apt install ffmpeg) or write numbered pictures instead");
        fail_to_write(file, "can't start ffmpeg: " + std::generic_category().message(error));
    }
    ~Impl() {
        close_socket();
        if (process > 0) {
            ::kill(process, SIGKILL);
            wait_for_process();
        }
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void close_socket() {
        if (socket >= 0) ::close(socket);
        socket = -1;
    }

    /// The program's exit status as waitpid gives it.
    int wait_for_process() {
        int status = 0;
        while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
        process = -1;
        return status;
    }

    /// Ends the program; throws unless it succeeded.
    void end_program() {
        close_socket();
        const int status = wait_for_process();
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
        std::string why = "ffmpeg failed";
        if (WIFSIGNALED(status)) why += std::string(" (") + ::strsignal(WTERMSIG(status)) + ")";
        const std::string said = last_lines(messages.get());
        fail_to_write(file, said.empty() ? why : why + ":\n" + said);
    }

    void send(const std::vector<std::uint8_t>& bytes) {
        std::size_t sent = 0;
        while (sent < bytes.size()) {
            const ssize_t count = ::send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) {
                const int error = errno;
                end_program();  // Throws with the program's own words, if it failed.
                fail_to_write(file, "ffmpeg stopped early: " + std::generic_category().message(error));
            }
            sent += static_cast<std::size_t>(count);
        }
    }

    fs::path file;
    int width, height;
    int coded_width = 0, coded_height = 0;
    std::size_t frames = 0;
    Replacement replacement;
    std::unique_ptr<std::FILE, CloseFile> messages;
    int socket = -1;
    pid_t process = -1;
};

VideoWriter::VideoWriter(const fs::path& file, int width, int height, double fps) {
    if (!is_video(file))
        throw OutputError("can't tell the video format of '" + file.string() +
                          "' by its ending; there are .mp4 .webm .gif");
    if (width <= 0 || height <= 0 || !(fps > 0) || !std::isfinite(fps))
        throw std::invalid_argument("a video needs a positive size and frame rate");
    impl_ = std::make_unique<Impl>(file, width, height, fps);
}

VideoWriter::~VideoWriter() = default;
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;

void VideoWriter::add(const Image& frame) {
    if (impl_ == nullptr || impl_->process < 0) throw std::logic_error("a frame added to a video that has ended");
    if (frame.width != impl_->width || frame.height != impl_->height)
        throw std::invalid_argument("all frames of a video must have its size");
    std::vector<std::uint8_t> codes = to_srgb8(frame);
    if (impl_->coded_width != frame.width || impl_->coded_height != frame.height) {
        const auto width = static_cast<std::size_t>(frame.width),
                   coded_width = static_cast<std::size_t>(impl_->coded_width);
        const auto coded_height = static_cast<std::size_t>(impl_->coded_height);
        std::vector<std::uint8_t> padded(3 * coded_width * coded_height);
        for (std::size_t y = 0; y < coded_height; ++y) {
            const std::size_t from = std::min(y, static_cast<std::size_t>(frame.height) - 1);
            for (std::size_t x = 0; x < coded_width; ++x)
                std::copy_n(&codes[3 * (from * width + std::min(x, width - 1))], 3, &padded[3 * (y * coded_width + x)]);
        }
        codes = std::move(padded);
    }
    impl_->send(codes);
    ++impl_->frames;
}

void VideoWriter::finish() {
    if (impl_ == nullptr || impl_->process < 0) throw std::logic_error("a video finished twice");
    if (impl_->frames == 0) fail_to_write(impl_->file, "a video without frames");
    impl_->end_program();
    impl_->replacement.commit();
}

}  // namespace sundog::output
