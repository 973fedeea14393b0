// SPDX-License-Identifier: Apache-2.0
// `sundog render`: what it was asked for, and its jobs.
#pragma once

#include <optional>
#include <string>

#include "arguments.h"
#include "blur_options.h"
#include "camera_views.h"
#include "compile/compile.h"
#include "denoise/denoiser.h"
#include "environment_options.h"
#include "import/import.h"
#include "indirect_options.h"
#include "light_options.h"
#include "output_plan.h"
#include "sampling_options.h"
#include "session/session.h"
#include "tone_options.h"

namespace sundog::app {

/// What `--show` asks for.
enum class Shown {
    picture,
    cost,  ///< Steps through the acceleration structure, instead of the picture.
    rays   ///< The picture, with the pixels that grid refinement traced in white.
};

/// The options of `sundog render`.
struct RenderArguments {
    std::string scene;  ///< Empty: raytracer.conf of the working folder.
    import::Choices choices;
    std::string output;  ///< Empty only with `pixel`.
    std::string format;
    std::string device = "auto";
    int threads = 0;  ///< 0: all.
    SamplingArguments sampling;
    LightArguments light;
    IndirectArguments indirect;
    float time_s = 0;
    float shutter_s = 0;  ///< How long it is open; 0: pictures are of one moment.
    BlurArguments blur;
    float exposure_ev = 0;
    ToneArguments tone;
    EnvironmentArguments environment;
    float frames_per_second = 25;
    std::optional<FrameRange> frames;
    std::optional<int> turntable;  ///< Frames of one turn round the scene.
    std::optional<View> view;      ///< Instead of the scene's camera.
    std::optional<Pixel> pixel;
    AovChoice aovs;
    std::optional<Acceleration> acceleration;  ///< If asked for: then on the CPU.
    PrimaryHits primary = PrimaryHits::automatic;
    Shown shown = Shown::picture;
    std::optional<denoise::Method> denoise;  ///< If asked for.
    bool quiet = false;
    FrameOptions frame;  ///< Size, camera and limits; its time and planes are set from the above.
};

/// A scene that stands on a device, ready for pictures.
struct Stage {
    const scene::Scene& scene;
    const RenderScene& compiled;
    Session& session;
    denoise::Denoiser* denoiser;  ///< Null: pictures keep their noise.
};

/// The jobs return the exit status. Errors: OutputError, DeviceError.
int render_image(const RenderArguments& arguments, const OutputPlan& plan, const Stage& stage);
int render_frames(const RenderArguments& arguments, const OutputPlan& plan, const Stage& stage);
/// Prints what one pixel sees.
int print_pixel(const RenderArguments& arguments, const Stage& stage);

}  // namespace sundog::app
