// SPDX-License-Identifier: Apache-2.0
#include "import/pov/kept_file.h"

#include <stdexcept>
#include <vector>

#include "base/text_file.h"
#include "output/file.h"
#include "scene/files.h"

namespace sundog::pov {

std::string read_kept_file(BuildContext& context, std::string_view name, Place where, const std::string& what) {
    const std::filesystem::path file = context.find_file(name, where);
    const std::string title = "the file of " + what + " " + in_quotes(name);
    if (file.empty()) context.fail(where, "can't find " + title, context.why_not_found(name, where));
    if (const auto reason = context.files.access().why_unreadable(file))
        context.fail(where, "can't read " + title, *reason);
    scene::add_file(context.scene, file);
    try {
        const std::vector<unsigned char> bytes = output::read_file(file);
        return {bytes.begin(), bytes.end()};
    } catch (const std::runtime_error& error) {
        context.fail(where, "can't read " + title, error.what());
    }
}

std::filesystem::path kept_file(BuildContext& context, std::string_view name, Place where) {
    std::filesystem::path file = context.files.output_path(name);
    if (const auto reason = context.files.access().why_unwritable(file))
        context.fail(where, "can't write to " + in_quotes(name), *reason);
    return file;
}

void write_kept_file(const std::filesystem::path& file, const std::string& bytes) {
    output::Replacement replacement(file);
    replacement.write(bytes);
    replacement.commit();
}

}  // namespace sundog::pov
