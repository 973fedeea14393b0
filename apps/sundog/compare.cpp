// SPDX-License-Identifier: Apache-2.0
#include "output/compare.h"

#include <fmt/format.h>

#include "base/diagnostics.h"
#include "command.h"
#include "output_plan.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  sundog compare cpu.png gpu.png\n"
    "  sundog compare before.png after.png -o difference.png --gain 10\n"
    "The difference image shows the distance of each channel (sRGB); with --flip the FLIP error map.";

struct CompareArguments {
    std::string a, b, output;
    float gain = 1;
    bool flip = false;
};

int compare_files(const CompareArguments& arguments) {
    if (arguments.a.empty() || arguments.b.empty())
        throw UsageError("two pictures are needed", "for example sundog compare a.png b.png");
    OutputPlan plan;
    if (!arguments.output.empty()) plan = plan_output(arguments.output, "", std::nullopt, false);

    const output::Image a = output::read_image(arguments.a);
    const output::Image b = output::read_image(arguments.b);
    if (a.width != b.width || a.height != b.height) {
        Diagnostic diagnostic;
        diagnostic.where.file = std::make_shared<const std::string>(arguments.b);
        diagnostic.message = fmt::format("{}x{} pixels can't be compared with {}x{} of '{}'", b.width, b.height,
                                         a.width, a.height, arguments.a);
        diagnostic.hint = "pictures of the same size are needed";
        throw InputError(diagnostic);
    }
    if (!arguments.output.empty()) {
        const output::Image difference =
            arguments.flip ? output::flip_image(a, b) : output::difference_image(a, b, arguments.gain);
        if (plan.target == Target::standard_output)
            output::write_file_atomically("-", output::encode(difference, plan.format));
        else output::write_image(plan.file, difference);
        if (plan.target == Target::standard_output) return 0;
    }
    const output::Comparison c = output::compare(a, b);
    fmt::print("size                {}x{}\n", a.width, a.height);
    fmt::print("RMSE                {:.6f}\n", c.rmse);
    fmt::print("PSNR                {:.2f} dB\n", c.psnr_db);
    fmt::print("SSIM                {:.6f}\n", c.ssim);
    fmt::print("FLIP                {:.6f}\n", c.flip);
    fmt::print("largest difference  {}/255\n", c.max_difference_8bit);
    fmt::print("differing pixels    {:.4f} % (by more than 2/255)\n", 100 * c.different_fraction);
    return 0;
}

}  // namespace

void add_compare(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand("compare", "Tell how far two pictures are apart");
    command->footer(kExamples);
    const auto arguments = std::make_shared<CompareArguments>();
    command->add_option("a", arguments->a, "A picture (.png .jpg .exr .hdr .ppm .tga .bmp)");
    command->add_option("b", arguments->b, "Another of the same size");
    command->add_option("-o,--output", arguments->output, "Write the difference image here");
    command
        ->add_option_function<std::string>(
            "--gain", [arguments](const std::string& text) { arguments->gain = parse_float("--gain", text, 0, 1000); },
            "Multiply the difference image (1)")
        ->type_name("G");
    command->add_flag("--flip", arguments->flip, "Write the FLIP error map instead");
    command->callback([arguments, &action] { action = [arguments] { return compare_files(*arguments); }; });
}

}  // namespace sundog::app
