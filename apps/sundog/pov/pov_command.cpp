// SPDX-License-Identifier: Apache-2.0
#include "pov_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>

#include "../console.h"
#include "../loading.h"
#include "../picture.h"
#include "../usage_error.h"
#include "alpha.h"
#include "animation.h"
#include "base/paths.h"
#include "command_line.h"
#include "compile/compile.h"
#include "import/pov/pov_import.h"
#include "ini_writer.h"
#include "output/file.h"
#include "output/progress_line.h"
#include "output_name.h"
#include "session/session.h"
#include "text_streams.h"

namespace sundog::app {
namespace {

namespace fs = std::filesystem;

// povray's exit statuses (reference, sections 3.2.2.4 and 3.2.6.3).
constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kUserAbort = 2;

/// Where povray's own include files lie on most systems: looked into after all library paths that were named, so that
/// scenes find colors.inc without a povray.ini.
constexpr const char* kCustomaryLibraries[] = {"/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include",
                                               "/usr/share/povray/include"};

/// Standard input as a file, since scenes are read from files. It goes away with this object.
class StandardInputFile {
public:
    StandardInputFile() {
        std::string pattern = (fs::temp_directory_path() / "sundog-stdin-XXXXXX").string();
        if (!::mkdtemp(pattern.data())) throw OutputError("can't make a folder for standard input in " + pattern);
        folder_ = pattern;
        std::ofstream(folder_ / "stdin.pov", std::ios::binary) << std::cin.rdbuf();
    }
    ~StandardInputFile() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    StandardInputFile(const StandardInputFile&) = delete;
    StandardInputFile& operator=(const StandardInputFile&) = delete;
    [[nodiscard]] fs::path path() const { return folder_ / "stdin.pov"; }

private:
    fs::path folder_;
};

/// The scene as it was named or with .pov, in the working folder or a library path.
fs::path find_scene(const PovSettings& settings) {
    std::vector<fs::path> folders{{}};
    folders.insert(folders.end(), settings.library_paths.begin(), settings.library_paths.end());
    for (const fs::path& folder : folders)
        for (const char* ending : {"", ".pov", ".POV"})
            if (fs::path file = folder / (settings.input_file + ending); is_file(file)) return file;
    // Reading it says what is wrong with it.
    return settings.input_file;
}

output::Format format_of(PovFileType type) {
    switch (type) {
        case PovFileType::bmp:
            return output::Format::bmp;
        case PovFileType::targa:
        case PovFileType::targa_rle:
            return output::Format::tga;
        case PovFileType::exr:
            return output::Format::exr;
        case PovFileType::hdr:
            return output::Format::hdr;
        case PovFileType::jpeg:
            return output::Format::jpg;
        case PovFileType::png:
            break;
        case PovFileType::ppm:
            return output::Format::ppm;
    }
    return output::Format::png;
}

output::Encoding encoding_of(const PovSettings& settings) {
    constexpr int kCustomaryJpegQuality = 85;  // Reference 3.2.4.1
    output::Encoding encoding;
    encoding.bits = settings.bits_per_color;
    encoding.gamma = settings.file_gamma;
    encoding.grayscale = settings.grayscale;
    encoding.run_length = settings.file_type == PovFileType::targa_rle;
    encoding.jpeg_quality = settings.jpeg_quality > 1 ? settings.jpeg_quality : kCustomaryJpegQuality;
    return encoding;
}

/// How pixels are sampled by povray's first method; by the second, render_recursive() does it.
AdaptiveSampling sampling_of(const PovSettings& settings) {
    const int side = settings.antialias_depth + (settings.sampling_method == 2 ? 1 : 0);
    return {settings.antialias_threshold, settings.antialias_gamma,
            settings.antialias ? static_cast<std::uint32_t>(side * side) : 1U};
}

/// One call of the command.
class PovRun {
public:
    PovRun(PovSettings settings, const fs::path& working_folder)
        : settings_(std::move(settings)),
          policy_(output_policy(settings_, working_folder)),
          text_(settings_, policy_, [](std::string_view text) { fmt::print(stderr, "{}", text); }) {}

    int run(const std::vector<Diagnostic>& earlier_warnings) {
        for (const Diagnostic& warning : earlier_warnings) warn(warning);
        for (const std::string& command : settings_.shell_commands)
            warn({Severity::warning, {}, command + " is not run: Sundog never starts a program", {}, {}});
        if (settings_.field_render)
            warn({Severity::warning, {}, "field rendering is not done: frames are whole pictures", {}, {}});
        if (settings_.input_file.empty()) throw UsageError("No input file provided", "for example: scene.pov");
        std::optional<StandardInputFile> standard_input;
        if (settings_.input_file == "-") standard_input.emplace();
        scene_file_ = standard_input ? standard_input->path() : find_scene(settings_);
        animation_ = animation_of(settings_);
        if (settings_.wanted == PovSettings::Wanted::formatted) return print_formatted();
        region_ = region_of(settings_);
        check_picture_memory({settings_.width, settings_.height}, {});
        write_ini();
        const InterruptGuard interrupt;
        for (int frame = animation_.first; frame <= animation_.last; frame += animation_.step)
            if (!render_frame(frame, interrupt.flag())) return kUserAbort;
        text_.write(PovText::statistic, "Sundog finished\n");
        return kDone;
    }

    void fail(std::string_view message) { text_.write(PovText::fatal, fmt::format("{}\nRender failed\n", message)); }

private:
    /// The scene of the first frame in normalised language, on standard output.
    int print_formatted() {
        const WarningSink sink = [this](const Diagnostic& diagnostic) { warn(diagnostic); };
        const std::string text = pov::format_pov(scene_file_, import_options(animation_.first, "-"), sink);
        if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
            throw OutputError("can't write the formatted scene to standard output");
        return kDone;
    }

    void warn(const Diagnostic& diagnostic) {
        if (settings_.warning_level > 0) text_.write(PovText::warning, format(diagnostic) + "\n");
    }

    void write_ini() {
        if (!settings_.create_ini) return;
        fs::path file = settings_.create_ini->name;
        if (file.empty()) file = fs::path(settings_.input_file).replace_extension(".ini");
        check_named_output(*settings_.create_ini, file, policy_);
        output::write_file_atomically(file, ini_text(settings_));
    }

    /// Where the frame goes; checked here, before the frame is read and rendered.
    [[nodiscard]] fs::path output_file(int frame) const {
        fs::path file = picture_file(settings_, animation_, frame);
        if (!settings_.output_to_file) return file;
        if (file == "-") {
            if (::isatty(STDOUT_FILENO) == 1)
                throw UsageError("+O- would put the picture on the terminal", "redirect standard output");
            return file;
        }
        // Without a name the picture lies beside the scene, which the command line or an INI file named.
        const NamedOutput named = settings_.output_file.value_or(NamedOutput{"", false});
        check_named_output(named, file, policy_);
        if (!output::is_special_file(file)) const output::Replacement trial(file);
        return file;
    }

    [[nodiscard]] pov::PovOptions import_options(int frame, const fs::path& file) {
        pov::PovOptions options;
        options.width = settings_.width;
        options.height = settings_.height;
        options.clock = animation_.clock_of(frame);
        options.library_paths.assign(settings_.library_paths.begin(), settings_.library_paths.end());
        for (const char* folder : kCustomaryLibraries) options.library_paths.emplace_back(folder);
        for (const PovSettings::Declaration& declared : settings_.declarations)
            options.declarations.push_back({declared.name, declared.value});
        options.include_header = settings_.include_header;
        // Without any #version povray takes a scene for one of the time before 3.7, and says so.
        options.version = 360;
        if (settings_.version) options.version = static_cast<std::uint16_t>(std::lround(*settings_.version * 100));
        if (settings_.max_steps) options.limits.steps = *settings_.max_steps;
        if (settings_.max_memory_mb) options.limits.memory_bytes = *settings_.max_memory_mb << 20U;
        options.access.sandbox = settings_.sandbox;
        options.access.writable.emplace_back(file == "-" || file.parent_path().empty() ? fs::path(".")
                                                                                       : file.parent_path());
        for (const std::string& folder : settings_.allow_write) options.access.writable.emplace_back(folder);
        options.radiosity_file = {settings_.radiosity_file, settings_.radiosity_from_file, settings_.radiosity_to_file};
        if (options.radiosity_file.name.empty()) options.radiosity_file.name = scene_file_.stem().string() + ".rca";
        options.print = [this](pov::PovStream stream, std::string_view text) {
            constexpr PovText kStreams[] = {PovText::debug, PovText::render, PovText::statistic, PovText::warning};
            text_.write(kStreams[static_cast<std::size_t>(stream)], text);
        };
        return options;
    }

    void report_options(int frame, const fs::path& file) {
        const pov::PovClock clock = animation_.clock_of(frame);
        text_.write(PovText::render,
                    fmt::format("Parser Options\n  Input file: {}\n  Clock value: {:.3f}  (Animation {})\n"
                                "Image Output Options\n  Image resolution.....{} by {} (rows {} to {}, columns {} to "
                                "{}).\n",
                                settings_.input_file, clock.clock, animation_.animated ? "on" : "off", settings_.width,
                                settings_.height, region_.y0 + 1, region_.y1, region_.x0 + 1, region_.x1));
        if (settings_.output_to_file)
            text_.write(PovText::render,
                        fmt::format("  Output file..........{}\n", file == "-" ? "stdout" : file.string()));
        if (animation_.animated)
            text_.write(PovText::render, fmt::format("Rendering frame {} of {}\n", frame, animation_.last));
    }

    /// False if the user interrupted it.
    bool render_frame(int frame, const StopFlag& stop) {
        const fs::path file = output_file(frame);
        // Files are written whole or not at all, so one that is there is done.
        if (settings_.continue_trace && animation_.animated && is_file(file)) return true;
        report_options(frame, file);
        text_.write(PovText::render, "==== [Parsing...] ====\n");
        const WarningSink sink = [this](const Diagnostic& diagnostic) { warn(diagnostic); };
        scene::Scene scene = pov::import_pov(scene_file_, import_options(frame, file), sink);
        const std::shared_ptr<const RenderScene> compiled = compile(scene, sink, false);
        if (stop.requested()) return interrupted(frame, nullptr, file);
        if (!session_) session_.emplace(open_device_for(*compiled, settings_.device, settings_.work_threads));
        session_->load(compiled);
        text_.write(PovText::render, "==== [Rendering...] ====\n");
        const RenderResult result = render_picture(scene, *compiled, stop);
        if (result.stopped) return interrupted(frame, &result.film, file);
        output::Image image = image_of(result.film, 0);
        if (settings_.output_alpha && settings_.output_to_file && !add_alpha_of(scene, image, stop))
            return interrupted(frame, nullptr, file);
        write_picture(std::move(image), file);
        report_statistics(result);
        return true;
    }

    [[nodiscard]] FrameOptions frame_options() const {
        FrameOptions options;
        options.width = settings_.width;
        options.height = settings_.height;
        // Reference 3.2.8.3
        if (settings_.quality < 4) options.shadows = false;
        if (settings_.quality < 8) {
            options.max_depth = 0;
            options.min_weight = 1e6F;  // Not straight on either.
        }
        options.radiosity = settings_.quality >= 9;
        options.subsurface = settings_.quality >= 9;
        return options;
    }

    RenderResult render_picture(const scene::Scene& scene, const RenderScene& compiled, const StopFlag& stop) {
        const Frame frame = make_frame(scene, compiled, frame_options());
        output::ProgressLine line(std::cerr, ::isatty(STDERR_FILENO) == 1 && console_is_on());
        const PixelRect region{region_.x0, region_.y0, region_.x1, region_.y1};
        RenderResult result =
            settings_.antialias && settings_.sampling_method == 2
                ? session_->render_recursive(
                      // Counts of samples say that povray's depth 1 is whole pixels.
                      frame, {settings_.antialias_threshold, settings_.antialias_gamma, settings_.antialias_depth - 1},
                      std::ref(line), stop, region)
                : session_->render_adaptive(frame, sampling_of(settings_), std::ref(line), stop, region);
        line.clear();
        return result;
    }

    /// Renders once more for the alpha of `image`; false if the user interrupted it. Changes `scene` on its way.
    bool add_alpha_of(scene::Scene& scene, output::Image& image, const StopFlag& stop) {
        if (!shows_transparent_sky(scene)) {
            image.alpha.assign(image.pixels.size(), 1.0F);
            return true;
        }
        const Vec3 sky = scene.sky;
        leave_only_the_sky(scene);
        const std::shared_ptr<const RenderScene> compiled = compile(scene, {}, false);
        session_->load(compiled);
        const RenderResult share =
            session_->render(make_frame(scene, *compiled, frame_options()), sampling_of(settings_).samples, {}, stop,
                             PixelRect{region_.x0, region_.y0, region_.x1, region_.y1});
        if (share.stopped) return false;
        scene.sky = sky;
        add_alpha(image, share.film, scene);
        return true;
    }

    [[nodiscard]] bool console_is_on() const {
        return settings_.text[static_cast<std::size_t>(PovText::render)].console;
    }

    /// The whole picture, black where nothing was to be rendered.
    void write_picture(output::Image image, const fs::path& file) {
        if (!settings_.output_to_file) return;
        if (!region_.is_all_of(settings_.width, settings_.height)) {
            output::Image whole(settings_.width, settings_.height);
            if (!image.alpha.empty()) whole.alpha.resize(whole.pixels.size());
            const auto place = [](const output::Image& in, int x, int y) {
                return static_cast<std::size_t>(y) * static_cast<std::size_t>(in.width) + static_cast<std::size_t>(x);
            };
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    whole.at(region_.x0 + x, region_.y0 + y) = image.at(x, y);
                    if (!image.alpha.empty())
                        whole.alpha[place(whole, region_.x0 + x, region_.y0 + y)] = image.alpha[place(image, x, y)];
                }
            image = std::move(whole);
        }
        output::write_file_atomically(
            file, output::encode(image, format_of(settings_.file_type), {}, encoding_of(settings_)));
    }

    /// A still picture is written as far as it is; of an animation whole frames are kept.
    bool interrupted(int frame, const Film* film, const fs::path& file) {
        if (film && !animation_.animated) {
            write_picture(image_of(*film, 0), file);
            text_.write(PovText::fatal, "Render halted by user; the picture holds what was done\n");
        } else {
            text_.write(PovText::fatal, fmt::format("Render halted by user in frame {}\n", frame));
        }
        return false;
    }

    void report_statistics(const RenderResult& result) {
        const int seconds = static_cast<int>(result.seconds);
        text_.write(
            PovText::statistic,
            fmt::format("Render Statistics\nImage Resolution {} x {}\nPixels: {}   Samples: {:.0f}   Rays: {}   "
                        "Shadow rays: {}\nTrace Time: {} hours {} minutes {} seconds ({:.3f} seconds) on {}\n",
                        settings_.width, settings_.height, result.film.radiance.size(), samples_taken(result),
                        result.stats.rays, result.stats.shadow_rays, seconds / 3600, seconds / 60 % 60, seconds % 60,
                        result.seconds, session_->device().info().name));
    }

    const PovSettings settings_;
    const FileAccess policy_;
    TextStreams text_;
    fs::path scene_file_;
    PovAnimation animation_;
    PovRegion region_;
    std::optional<Session> session_;
};

/// Calls `work` and tells `say` why it failed.
template <typename Work, typename Say>
int guarded(Work work, Say say) {
    try {
        return work();
    } catch (const UsageError& error) {
        say(std::string("Error: ") + error.what() + (error.hint().empty() ? "" : "\nhint: " + error.hint()));
    } catch (const InputError& error) {
        say(error.what());
    } catch (const OutputError& error) {
        say(std::string("Error: ") + error.what());
    } catch (const DeviceError& error) {
        say(std::string("Error: ") + error.what());
    } catch (const std::bad_alloc&) {
        say("Error: there is not enough memory for this");
    }
    return kFailed;
}

}  // namespace

int run_pov(const std::vector<std::string>& words, std::string_view version) {
    std::vector<Diagnostic> warnings;
    const PovSurroundings surroundings = surroundings_of_process();
    std::optional<PovSettings> settings;
    // Before the settings are known there are no streams to write to.
    const int status = guarded(
        [&] {
            settings = read_command_line(words, surroundings, [&](const Diagnostic& d) { warnings.push_back(d); });
            return kDone;
        },
        [](const std::string& message) { fmt::print(stderr, "Problem with option setting\n{}\n", message); });
    if (status != kDone) return status;
    if (settings->wanted == PovSettings::Wanted::help) {
        fmt::print("{}", pov_help());
        return kDone;
    }
    if (settings->wanted == PovSettings::Wanted::version) {
        fmt::print("Sundog {}, for scenes of POV-Ray 3.7\n", version);
        return kDone;
    }
    std::optional<PovRun> run;
    return guarded(
        [&] {
            run.emplace(std::move(*settings), surroundings.working_folder);
            return run->run(warnings);
        },
        [&](const std::string& message) {
            if (run) run->fail(message);
            else fmt::print(stderr, "{}\n", message);
        });
}

}  // namespace sundog::app
