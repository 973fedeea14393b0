// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/vulkan_device.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

#include "base/diagnostics.h"
#include "device/vulkan/chunks.h"
#include "device/vulkan/film_buffers.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/pipelines.h"
#include "device/vulkan/scene_buffers.h"
#include "device/vulkan/shaders/path_media_spirv.h"
#include "device/vulkan/shaders/path_rare_media_spirv.h"
#include "device/vulkan/shaders/path_rare_solids_media_spirv.h"
#include "device/vulkan/shaders/path_rare_solids_spirv.h"
#include "device/vulkan/shaders/path_rare_spirv.h"
#include "device/vulkan/shaders/path_solids_media_spirv.h"
#include "device/vulkan/shaders/path_solids_spirv.h"
#include "device/vulkan/shaders/path_spirv.h"
#include "device/vulkan/shaders/whitted_media_spirv.h"
#include "device/vulkan/shaders/whitted_rare_media_spirv.h"
#include "device/vulkan/shaders/whitted_rare_solids_media_spirv.h"
#include "device/vulkan/shaders/whitted_rare_solids_spirv.h"
#include "device/vulkan/shaders/whitted_rare_spirv.h"
#include "device/vulkan/shaders/whitted_solids_media_spirv.h"
#include "device/vulkan/shaders/whitted_solids_spirv.h"
#include "device/vulkan/shaders/whitted_spirv.h"

namespace sundog {
namespace {

using namespace vulkan;

/// A piece of a RenderWork that one dispatch computes.
struct Piece {
    PixelRect rect;
    std::uint32_t first_sample;
    std::uint32_t sample_count;
};

/// Of the shaders that Pipelines gets. Those that find exact solids, too, need doubles, which not all GPUs have; those
/// that draw media are larger than the others.
constexpr std::uint32_t kWhittedShader = 0, kPathShader = 1, kSolidShaders = 2, kMediaShaders = 4, kRareShaders = 8;

class VulkanDevice final : public Device {
public:
    VulkanDevice(std::size_t index, const VulkanOptions& options)
        : gpu_(index, options.on_validation_message, {options.map_device_memory, options.staging_bytes}),
          pipelines_(gpu_,
                     {whitted_spirv, path_spirv, whitted_solids_spirv, path_solids_spirv, whitted_media_spirv,
                      path_media_spirv, whitted_solids_media_spirv, path_solids_media_spirv, whitted_rare_spirv,
                      path_rare_spirv, whitted_rare_solids_spirv, path_rare_solids_spirv, whitted_rare_media_spirv,
                      path_rare_media_spirv, whitted_rare_solids_media_spirv, path_rare_solids_media_spirv},
                     kernel::BINDING_COUNT, sizeof(kernel::Dispatch)) {}

    [[nodiscard]] const DeviceInfo& info() const override { return gpu_.adapter().info; }

    [[nodiscard]] std::vector<std::string> unsupported(const RenderScene& scene) const override {
        std::vector<std::string> sentences = not_drawn_by_shaders(scene, gpu_.adapter());
        for (std::string& sentence : arrays_too_large(scene, gpu_.adapter())) sentences.push_back(std::move(sentence));
        return sentences;
    }

    void load(std::shared_ptr<const RenderScene> scene) override {
        // The old scene goes first: both may not fit.
        buffers_.reset();
        scene_ = std::move(scene);
        pace_ = Pace();
        most_samples_ = std::numeric_limits<std::uint32_t>::max();
        buffers_.emplace(gpu_, pipelines_, *scene_);
    }

    [[nodiscard]] std::size_t memory_bytes() const override { return buffers_ ? buffers_->memory_bytes() : 0; }

    RenderStats render(const Frame& frame, const RenderWork& work, Film& film, const StopFlag& stop) override {
        if (!buffers_) throw DeviceError("no scene was loaded");
        RenderStats stats;
        if (work.sample_count == 0) return stats;
        Variant variant;
        variant.shader = frame.params.integrator == kernel::INTEGRATOR_WHITTED ? kWhittedShader : kPathShader;
        variant.integrator = frame.params.integrator;
        variant.program_ops = scene_->program_ops;
        variant.program_fields = scene_->program_fields;
        if ((frame.params.features & kernel::FEATURE_MEDIA) != 0) variant.shader += kMediaShaders;
        if ((scene_->program_ops & kernel::OP_RARE) != 0 || (scene_->program_fields & kernel::FIELD_RARE) != 0)
            variant.shader += kRareShaders;
        if (buffers_->solid_kinds() != 0) {
            variant.shader += kSolidShaders;
            variant.solid_kinds = buffers_->solid_kinds();
            // Few different sizes, so that few variants of the shader are compiled.
            variant.solid_depth = (buffers_->solid_depth() + 3) / 4 * 4;
        }
        variant.stack_size = buffers_->set_frame(gpu_, pipelines_, frame);
        variant.aovs = film.aovs;
        variant.features =
            (frame.params.features & ~kernel::FEATURE_INSTANCES) | (scene_->features & kernel::FEATURE_INSTANCES);
        const VkPipeline pipeline = pipelines_.get(variant);
        const std::uint64_t most_pixels = FilmBuffers::most_pixels(gpu_.adapter(), film.aovs);
        for (Chunks chunks(work.region); !chunks.done();) {
            Piece piece{chunks.next(std::min(pace_.paths(), most_pixels)), work.first_sample, 0};
            const std::uint32_t end = work.first_sample + work.sample_count;
            while (piece.first_sample < end) {
                if (stop.requested()) {
                    stats.complete = false;
                    return stats;
                }
                const std::uint64_t pixels = pixels_of(piece);
                piece.sample_count = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(
                    pace_.paths() / pixels, 1, std::min(end - piece.first_sample, most_samples_)));
                const DispatchCounts counts = render_piece(pipeline, piece, film);
                if (counts.cut_loops) {
                    shorten_dispatches(piece.sample_count);
                    continue;
                }
                stats.rays += counts.rays;
                stats.shadow_rays += counts.shadow_rays;
                piece.first_sample += piece.sample_count;
            }
        }
        return stats;
    }

private:
    static std::uint64_t pixels_of(const Piece& piece) {
        return static_cast<std::uint64_t>(piece.rect.width()) * static_cast<std::uint64_t>(piece.rect.height());
    }

    /// The driver ended loops early: fewer samples at a time go through fewer rounds.
    void shorten_dispatches(std::uint32_t sample_count) {
        if (sample_count == 1) {
            throw DeviceError("the driver of '" + info().name +
                              "' ends a shader's loops early, and this picture needs all of their rounds; use "
                              "--device cpu");
        }
        most_samples_ = sample_count / 2;
    }

    /// Leaves the film alone where the driver ended loops early.
    DispatchCounts render_piece(VkPipeline pipeline, const Piece& piece, Film& film) {
        film_buffers_.reserve(gpu_, pipelines_, pixels_of(piece), film.aovs);
        const bool continues = piece.first_sample != 0;
        if (continues) film_buffers_.fetch(gpu_, film, piece.rect);
        const PixelRect& rect = piece.rect;
        const kernel::Dispatch dispatch{static_cast<std::uint32_t>(rect.x0),
                                        static_cast<std::uint32_t>(rect.y0),
                                        static_cast<std::uint32_t>(rect.width()),
                                        static_cast<std::uint32_t>(rect.height()),
                                        piece.first_sample,
                                        piece.sample_count,
                                        2};
        const auto start = std::chrono::steady_clock::now();
        gpu_.run([&](VkCommandBuffer commands) {
            const DeviceFunctions& f = gpu_.functions();
            film_buffers_.record_before(gpu_, commands, rect, continues);
            f.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
            const VkDescriptorSet set = pipelines_.set();
            f.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_.layout(), 0, 1, &set, 0,
                                      nullptr);
            f.vkCmdPushConstants(commands, pipelines_.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(dispatch),
                                 &dispatch);
            f.vkCmdDispatch(commands, (dispatch.width + kernel::GROUP_WIDTH - 1) / kernel::GROUP_WIDTH,
                            (dispatch.height + kernel::GROUP_HEIGHT - 1) / kernel::GROUP_HEIGHT, 1);
            film_buffers_.record_after(gpu_, commands, rect, film.aovs != 0);
        });
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        pace_.learn(pixels_of(piece) * piece.sample_count, seconds.count());
        const DispatchCounts counts = film_buffers_.counts(gpu_);
        if (!counts.cut_loops) film_buffers_.store(gpu_, film, rect, piece.first_sample);
        return counts;
    }

    Gpu gpu_;
    Pipelines pipelines_;
    std::shared_ptr<const RenderScene> scene_;
    std::optional<SceneBuffers> buffers_;
    FilmBuffers film_buffers_;
    Pace pace_;
    std::uint32_t most_samples_ = std::numeric_limits<std::uint32_t>::max();  ///< Of a pixel in one dispatch.
};

}  // namespace

std::vector<VulkanAdapter> vulkan_adapters(std::string& why) {
    std::vector<VulkanAdapter> adapters;
    why.clear();
    try {
        const Instance instance;
        for (VkPhysicalDevice device : instance.physical_devices()) {
            Adapter adapter = probe(instance, device);
            adapters.push_back({std::move(adapter.info), std::move(adapter.why_unusable)});
        }
        if (adapters.empty()) why = "no Vulkan driver found a GPU";
    } catch (const DeviceError& error) {
        why = error.what();
    }
    return adapters;
}

std::unique_ptr<Device> make_vulkan_device(std::size_t index, const VulkanOptions& options) {
    return std::make_unique<VulkanDevice>(index, options);
}

}  // namespace sundog
