// SPDX-License-Identifier: Apache-2.0
// Each function of the kernel on random arguments: several lanes against one to the bit, GPU against CPU within the
// tolerance that is stated for it.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "device/vulkan/gpu.h"
#include "device/vulkan/scene_buffers.h"
#include "function_cases.h"
#include "parity/kernel_calls_spirv.h"
#include "test_devices.h"

namespace sundog::parity {
namespace {

constexpr std::size_t kBatches = 32;
/// Share of calls in which a yes may be a no, or a texel the next one: arguments within rounding of the border.
constexpr double kAllowedFlips = 2e-3;

/// The textured scene: some functions read its arrays.
Prepared textured_scene() {
    for (const TestScene& test : test_scenes()) {
        if (test.name == "textures") return prepare(test, 64, 64);
    }
    throw std::runtime_error("no test scene called textures");
}

using Results = std::vector<CallValues>;

Results call_on_cpu(CallLanes lanes, const Prepared& prepared, const FunctionCase& function,
                    const Arguments& arguments) {
    Results results(arguments.varying.size());
    lanes(*prepared.scene, prepared.frame, function.function, arguments.uniforms, arguments.varying, results);
    return results;
}

class LanesParity : public testing::TestWithParam<FunctionCase> {};

// Catches an operation that rounds otherwise in several lanes than in one, or that mixes lanes up: pictures must have
// the same bits on every processor.
TEST_P(LanesParity, SeveralLanesGiveTheBitsOfOne) {
    const Prepared prepared = textured_scene();
    const Arguments arguments = random_arguments(GetParam(), kBatches);
    const Results one = call_on_cpu(call_lanes_1, prepared, GetParam(), arguments);
    const auto compare = [&](CallLanes lanes, int width) {
        const Results several = call_on_cpu(lanes, prepared, GetParam(), arguments);
        for (std::size_t i = 0; i < one.size(); ++i) {
            for (std::size_t v = 0; v < one[i].size(); ++v) {
                if (std::isnan(one[i][v]) && std::isnan(several[i][v])) continue;
                ASSERT_EQ(std::bit_cast<std::uint32_t>(one[i][v]), std::bit_cast<std::uint32_t>(several[i][v]))
                    << width << " lanes, call " << i << ", result " << v << ": " << one[i][v] << " and "
                    << several[i][v];
            }
        }
    };
    if (__builtin_cpu_supports("sse4.2")) compare(call_lanes_4, 4);
    if (__builtin_cpu_supports("avx2")) compare(call_lanes_8, 8);
    if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512vl")) {
        compare(call_lanes_16, 16);
    }
}

/// Runs the compute shader over all functions' arguments on one GPU.
class GpuCalls {
public:
    GpuCalls(const Prepared& prepared, std::vector<std::string>& messages)
        : gpu_(0, [&messages](std::string_view message) { messages.emplace_back(message); }),
          pipelines_(gpu_, {kernel_calls_spirv}, kernel::BINDING_COUNT, sizeof(std::uint32_t)),
          scene_(gpu_, pipelines_, *prepared.scene) {
        scene_.set_frame(gpu_, pipelines_, prepared.frame);
        pipeline_ = pipelines_.get({0, prepared.frame.params.features, 0, 1, 0});
    }

    Results call(const FunctionCase& function, const Arguments& arguments) {
        const std::size_t bytes = arguments.varying.size() * sizeof(CallValues);
        const vulkan::Buffer uniforms =
            vulkan::make_storage(gpu_, std::as_bytes(std::span(arguments.uniforms)), "uniforms");
        const vulkan::Buffer varying =
            vulkan::make_storage(gpu_, std::as_bytes(std::span(arguments.varying)), "arguments");
        const vulkan::Buffer results(gpu_, bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vulkan::Memory::readback,
                                     "results");
        pipelines_.bind(kernel::BINDING_NODES, uniforms);
        pipelines_.bind(kernel::BINDING_RADIANCE, varying);
        pipelines_.bind(kernel::BINDING_AOVS, results);
        gpu_.run([&](VkCommandBuffer commands) {
            const vulkan::DeviceFunctions& f = gpu_.functions();
            const VkDescriptorSet set = pipelines_.set();
            f.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
            f.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_.layout(), 0, 1, &set, 0,
                                      nullptr);
            f.vkCmdPushConstants(commands, pipelines_.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                                 sizeof(function.function), &function.function);
            f.vkCmdDispatch(commands, static_cast<std::uint32_t>(arguments.uniforms.size()), 1, 1);
            VkMemoryBarrier barrier{};
            barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
            barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
            barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
            f.vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                                   &barrier, 0, nullptr, 0, nullptr);
        });
        results.invalidate(gpu_);
        Results out(arguments.varying.size());
        std::memcpy(out.data(), results.mapped().data(), bytes);
        return out;
    }

private:
    vulkan::Gpu gpu_;
    vulkan::Pipelines pipelines_;
    vulkan::SceneBuffers scene_;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

/// Calls whose results lie too far apart; `worst` names one of them.
std::size_t calls_apart(const FunctionCase& function, const Results& cpu, const Results& gpu, std::string& worst) {
    std::size_t apart = 0;
    for (std::size_t i = 0; i < cpu.size(); ++i) {
        const bool both_no = function.decides && cpu[i][0] == 0 && gpu[i][0] == 0;
        bool near = true;
        for (std::size_t v = 0; v < cpu[i].size() && !both_no; ++v) {
            const float a = cpu[i][v];
            const float b = gpu[i][v];
            if (a == b || (std::isnan(a) && std::isnan(b))) continue;
            if (std::fabs(a - b) <= function.relative * std::fabs(a) + function.absolute) continue;
            near = false;
            worst = "call " + std::to_string(i) + ", result " + std::to_string(v) + ": " + std::to_string(a) + " and " +
                    std::to_string(b);
        }
        if (!near) ++apart;
    }
    return apart;
}

// Catches a kernel function that means something else in GLSL than in C++: an operator, a built-in function, a macro, a
// struct's layout, an array's binding. One test for all, since compiling the shader takes longer than running it.
TEST(FunctionParity, GpuAndCpuAgree) {
    std::string why;
    std::vector<std::string> messages;
    if (!open_gpu(messages, why)) GTEST_SKIP() << "no GPU to compare with: " << why;
    const Prepared prepared = textured_scene();
    GpuCalls gpu(prepared, messages);
    for (const FunctionCase& function : function_cases()) {
        SCOPED_TRACE(function.name);
        const Arguments arguments = random_arguments(function, kBatches);
        const Results on_cpu = call_on_cpu(call_lanes_1, prepared, function, arguments);
        const Results on_gpu = gpu.call(function, arguments);
        std::string worst;
        const std::size_t apart = calls_apart(function, on_cpu, on_gpu, worst);
        EXPECT_LE(static_cast<double>(apart), kAllowedFlips * static_cast<double>(on_cpu.size())) << worst;
    }
    for (const std::string& message : messages) ADD_FAILURE() << message;
}

// Catches a table of functions that skips one: it could break unseen.
TEST(FunctionParity, CoversEveryNumber) {
    const auto cases = function_cases();
    ASSERT_EQ(cases.size(), kernel::CALL_COUNT);
    for (std::uint32_t i = 0; i < cases.size(); ++i) EXPECT_EQ(cases[i].function, i);
}

INSTANTIATE_TEST_SUITE_P(Functions, LanesParity, testing::ValuesIn(function_cases()),
                         [](const testing::TestParamInfo<FunctionCase>& info) { return info.param.name; });

}  // namespace

/// How GoogleTest shows the parameter.
void PrintTo(const FunctionCase& function, std::ostream* stream) { *stream << function.name; }

}  // namespace sundog::parity
