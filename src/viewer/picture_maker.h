// SPDX-License-Identifier: Apache-2.0
// Makes the window's pictures, one call after the other; knows no threads and no window.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "compile/compile.h"
#include "output/image.h"
#include "session/session.h"
#include "viewer/clean_picture.h"
#include "viewer/display.h"
#include "viewer/faster_way.h"
#include "viewer/frame_budget.h"
#include "viewer/loaded_scene.h"

namespace sundog::viewer {

/// What the window wants to see.
struct ViewRequest {
    std::shared_ptr<const LoadedScene> scene;
    std::string device;    ///< As open_device() takes it.
    FrameOptions options;  ///< At the window's full size: width, height and camera must be set.
    Exposure exposure;
    bool denoise = false;    ///< Take the noise out of pictures at rest.
    bool show_rays = false;  ///< Paint the pixels white that grid refinement traces.
};

/// True where both ask for the same picture, exposure aside.
bool same_radiance(const ViewRequest& a, const ViewRequest& b);

/// A picture, ready for the screen.
struct Picture {
    PixelSize size;                   ///< What was rendered; smaller than the window while things move.
    std::vector<std::uint32_t> argb;  ///< 0xAARRGGBB, row by row.
    float time_s = 0;                 ///< The moment it shows.
    std::uint32_t samples = 0;        ///< A pixel.
    double seconds = 0;               ///< That its last pass took to render.
    std::uint64_t rays = 0;           ///< Of that pass.
};

/// Opens a device by the name that the user chose. Errors: DeviceError.
using DeviceOpener = std::function<std::unique_ptr<Device>(const std::string& choice)>;

/// Renders what is requested: at a reduced size within the frame budget, or at full size, sample after sample.
class PictureMaker {
public:
    /// target_frame_s: for pictures of reduced size. max_samples: a pixel, at full size. denoiser: what takes the noise
    /// out where that is requested.
    PictureMaker(DeviceOpener open_device, double target_frame_s, std::uint32_t max_samples,
                 denoise::Method denoiser = denoise::Method::automatic);

    /// What to render from now on. Opens another device or loads another scene where the request asks for it; then
    /// returns the device. Errors: DeviceError; a device that can't be opened leaves the one before in use, one that
    /// can't take the scene leaves none.
    std::optional<DeviceInfo> set_request(ViewRequest request);
    [[nodiscard]] const ViewRequest& request() const { return request_; }
    /// True if there is a device with a scene; the calls below need it.
    [[nodiscard]] bool ready() const { return session_ != nullptr; }
    /// Samples a pixel of what show() gives.
    [[nodiscard]] std::uint32_t samples() const { return samples_; }

    /// A whole picture of one sample, as large as the budget allows. False if it was stopped.
    bool render_quickly(const StopFlag& stop);
    /// The next sample at full size, or its noise taken out, or, where rays are to be shown, the picture with these at
    /// full size. False if it was stopped; what was there before then still shows.
    bool refine(const StopFlag& stop);
    /// False once the full-size picture has all its samples and was denoised, if it is to be, or shows rays.
    [[nodiscard]] bool can_refine() const;
    /// Traces one pixel of the full-size picture.
    PixelInfo pick(int x, int y);
    /// The picture at full size, with at least a few samples, without rays, denoised where that was asked for; none if
    /// it was stopped.
    std::optional<output::Image> full_image(const StopFlag& stop);
    /// What has been rendered, for the screen.
    void show(Picture& picture) const;

private:
    [[nodiscard]] PixelSize full_size() const;
    [[nodiscard]] Frame frame_of(PixelSize size, std::uint32_t aovs = 0) const;
    bool trace_sample(const StopFlag& stop);
    bool show_rays_at_full_size(const StopFlag& stop);
    [[nodiscard]] bool holds_full_size() const;
    [[nodiscard]] bool cleaning_is_due() const;
    bool clean(const StopFlag& stop);
    [[nodiscard]] bool holds_rays_at_full_size() const;
    [[nodiscard]] bool fills_the_window() const;
    [[nodiscard]] std::uint32_t most_samples() const;
    /// Planes of a picture that is made by grid refinement.
    [[nodiscard]] std::uint32_t refined_aovs() const { return request_.show_rays ? kernel::AOV_COST : 0U; }

    DeviceOpener open_device_;
    std::uint32_t max_samples_;
    FrameBudget budget_;
    FasterWay faster_way_;
    ViewRequest request_;
    std::unique_ptr<Session> session_;
    std::string device_choice_;
    std::shared_ptr<const LoadedScene> loaded_;  // what session_ holds
    Film film_{PixelRect{}};
    CleanPicture clean_;            // of film_, if request_ asks for it
    bool film_is_current_ = false;  // film_ shows request_
    bool film_is_traced_ = false;   // in all its pixels: nothing is interpolated
    bool refinable_ = false;        // the device has grid refinement for request_
    std::uint32_t samples_ = 0;
    RenderStats last_pass_;
    double last_pass_s_ = 0;
};

}  // namespace sundog::viewer
