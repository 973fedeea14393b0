// SPDX-License-Identifier: Apache-2.0
#include "denoise/oidn_library.h"

#include <dlfcn.h>

#include <array>
#include <initializer_list>
#include <type_traits>

#include "denoise/oidn.h"

namespace sundog::denoise {
namespace {

using Handle = std::unique_ptr<void, void (*)(void*)>;

Handle open(const std::string& name) {
    // It stays loaded: its threads may outlive the last device.
    return {dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE), [](void* handle) {
                if (handle) dlclose(handle);
            }};
}

/// Looks functions up; keeps the name of the first one that is missing.
class Finder {
public:
    explicit Finder(void* library) : library_(library) {}
    /// The first of `names` that there is.
    template <class Function>
    void find(Function& function, std::initializer_list<const char*> names) {
        for (const char* name : names)
            if ((function = reinterpret_cast<Function>(dlsym(library_, name)))) return;
        if (missing_.empty()) missing_ = *names.begin();
    }
    [[nodiscard]] const std::string& missing() const { return missing_; }

private:
    void* library_;
    std::string missing_;
};

/// Fills `f`. Returns the name of a function that is missing, if one is.
std::string find_all(void* library, OidnFunctions& f) {
    Finder finder(library);
    finder.find(f.new_device, {"oidnNewDevice"});
    finder.find(f.commit_device, {"oidnCommitDevice"});
    finder.find(f.release_device, {"oidnReleaseDevice"});
    finder.find(f.get_device_int, {"oidnGetDeviceInt", "oidnGetDevice1i"});
    finder.find(f.get_device_error, {"oidnGetDeviceError"});
    finder.find(f.new_filter, {"oidnNewFilter"});
    finder.find(f.release_filter, {"oidnReleaseFilter"});
    finder.find(f.set_shared_filter_image, {"oidnSetSharedFilterImage"});
    finder.find(f.set_filter_bool, {"oidnSetFilterBool", "oidnSetFilter1b"});
    finder.find(f.set_filter_monitor, {"oidnSetFilterProgressMonitorFunction"});
    finder.find(f.commit_filter, {"oidnCommitFilter"});
    finder.find(f.execute_filter, {"oidnExecuteFilter"});
    return finder.missing();
}

}  // namespace

std::span<const std::string> oidn_names() {
    static const std::array<std::string, 4> names{"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1",
                                                  "libOpenImageDenoise.so.0", "libOpenImageDenoise.so"};
    return names;
}

OidnLibrary::OidnLibrary(std::span<const std::string> names) : handle_(nullptr, [](void*) {}) {
    std::string reasons;
    const auto add_reason = [&](const std::string& reason) { reasons += (reasons.empty() ? "" : "; ") + reason; };
    for (const std::string& name : names) {
        Handle handle = open(name);
        if (!handle) {
            const char* reason = dlerror();
            add_reason(reason ? reason : name + " can't be opened");
            continue;
        }
        const std::string missing = find_all(handle.get(), functions_);
        if (missing.empty()) {
            handle_ = std::move(handle);
            return;
        }
        add_reason(name + " lacks " + missing);
    }
    throw OidnError("Open Image Denoise can't be loaded: " + reasons);
}

}  // namespace sundog::denoise
