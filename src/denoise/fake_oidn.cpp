// SPDX-License-Identifier: Apache-2.0
// A library that can be taken for Open Image Denoise and looks closely at how it is called: for tests. What is wrong
// becomes the device's error. Built several times: FAKE_OIDN_VERSION is 1 or 2; FAKE_OIDN_FAILS says at what it fails;
// FAKE_OIDN_LACKS_EXECUTE leaves a function out. Its declarations are its own, so that a slip in the program's isn't
// made twice.
#include <cstddef>
#include <cstring>
#include <map>
#include <memory>
#include <string>

namespace fake_oidn {

inline bool fails_at(const char* step) { return std::strcmp(FAKE_OIDN_FAILS, step) == 0; }

struct Device {
    bool committed = false;
    int error = 0;
    std::string message, told;
    int filters = 0;
    void fail(int code, const std::string& what) {
        if (error == 0) error = code, message = what;
    }
};

struct Image {
    char* pixels = nullptr;
    std::size_t width = 0, height = 0, pixel_stride = 0, row_stride = 0;
    [[nodiscard]] float* at(std::size_t x, std::size_t y) const {
        return reinterpret_cast<float*>(pixels + y * row_stride + x * pixel_stride);
    }
};

struct Filter {
    Device* device = nullptr;
    std::map<std::string, Image> images;
    std::map<std::string, bool> switches;
    bool (*monitor)(void*, double) = nullptr;
    void* user = nullptr;
    bool committed = false;
};

inline int device_int(Device* device, const char* name) {
    if (std::strcmp(name, "version") == 0) return FAKE_OIDN_VERSION == 1 ? 10403 : 20301;
    device->fail(2, std::string("no such parameter: ") + name);
    return 0;
}

inline void set_bool(Filter* filter, const char* name, bool value) {
    if (std::strcmp(name, "hdr") != 0 && std::strcmp(name, "cleanAux") != 0)
        filter->device->fail(2, std::string("no such switch: ") + name);
    filter->switches[name] = value;
    filter->committed = false;
}

/// Why the filter can't be committed; empty if it can.
inline std::string fault(const Filter& filter) {
    const auto output = filter.images.find("output");
    if (output == filter.images.end() || filter.images.count("color") == 0) return "color or output is missing";
    if (filter.images.count("normal") != 0 && filter.images.count("albedo") == 0) return "normals without albedo";
    for (const auto& [name, image] : filter.images)
        if (image.width != output->second.width || image.height != output->second.height)
            return name + " is of another size than the output";
    return {};
}

}  // namespace fake_oidn

using fake_oidn::Device;
using fake_oidn::Filter;
using fake_oidn::Image;

extern "C" {

Device* oidnNewDevice(int kind) {
    if (fake_oidn::fails_at("new device") || kind != 1) return nullptr;
    return std::make_unique<Device>().release();
}

void oidnCommitDevice(Device* device) {
    if (fake_oidn::fails_at("commit device")) device->fail(5, "the hardware is not supported");
    if (device->committed) device->fail(3, "committed twice");
    device->committed = true;
}

void oidnReleaseDevice(Device* device) { std::unique_ptr<Device>(device).reset(); }

int oidnGetDeviceError(Device* device, const char** message) {
    if (!device) {
        *message = "no device of this kind";
        return 5;
    }
    const int error = device->error;
    device->told = device->message;
    device->error = 0;
    device->message.clear();
    *message = error == 0 ? nullptr : device->told.c_str();
    return error;
}

#if FAKE_OIDN_VERSION == 1
int oidnGetDevice1i(Device* device, const char* name) { return fake_oidn::device_int(device, name); }
void oidnSetFilter1b(Filter* filter, const char* name, bool value) { fake_oidn::set_bool(filter, name, value); }
#else
int oidnGetDeviceInt(Device* device, const char* name) { return fake_oidn::device_int(device, name); }
void oidnSetFilterBool(Filter* filter, const char* name, bool value) { fake_oidn::set_bool(filter, name, value); }
#endif

Filter* oidnNewFilter(Device* device, const char* kind) {
    if (!device->committed) device->fail(3, "the device is not committed");
    if (std::strcmp(kind, "RT") != 0) device->fail(2, std::string("no such filter: ") + kind);
    if (++device->filters != 1) device->fail(3, "the last filter was not released");
    auto filter = std::make_unique<Filter>();
    filter->device = device;
    return filter.release();
}

void oidnReleaseFilter(Filter* filter) {
    --filter->device->filters;
    std::unique_ptr<Filter>(filter).reset();
}

void oidnSetSharedFilterImage(Filter* filter, const char* name, void* pixels, int format, std::size_t width,
                              std::size_t height, std::size_t offset, std::size_t pixel_stride,
                              std::size_t row_stride) {
    if (format != 3) filter->device->fail(2, std::string(name) + " is not of three floats");
    if (!pixels) filter->device->fail(2, std::string(name) + " is nowhere");
    if (pixel_stride == 0) pixel_stride = 3 * sizeof(float);
    if (row_stride == 0) row_stride = width * pixel_stride;
    filter->images[name] = {static_cast<char*>(pixels) + offset, width, height, pixel_stride, row_stride};
    filter->committed = false;
}

void oidnSetFilterProgressMonitorFunction(Filter* filter, bool (*monitor)(void*, double), void* user) {
    filter->monitor = monitor;
    filter->user = user;
}

void oidnCommitFilter(Filter* filter) {
    const std::string what = fake_oidn::fault(*filter);
    if (!what.empty()) filter->device->fail(3, what);
    filter->committed = what.empty();
}

#ifndef FAKE_OIDN_LACKS_EXECUTE
/// Colour, 10 times albedo, 100 times normal; 1000 more where these are said to be clean; halves of all that where the
/// colour isn't said to be HDR.
void oidnExecuteFilter(Filter* filter) {
    if (fake_oidn::fails_at("execute")) return filter->device->fail(4, "there is not enough memory");
    if (!filter->committed) return filter->device->fail(3, "the filter is not committed");
    const Image& out = filter->images["output"];
    for (std::size_t y = 0; y < out.height; ++y) {
        if (filter->monitor && !filter->monitor(filter->user, static_cast<double>(y) / static_cast<double>(out.height)))
            return filter->device->fail(6, "it was cancelled");
        for (std::size_t x = 0; x < out.width; ++x)
            for (int c = 0; c < 3; ++c) {
                float sum = filter->switches["cleanAux"] ? 1000 : 0;
                sum += filter->images["color"].at(x, y)[c];
                if (filter->images.count("albedo") != 0) sum += 10 * filter->images["albedo"].at(x, y)[c];
                if (filter->images.count("normal") != 0) sum += 100 * filter->images["normal"].at(x, y)[c];
                out.at(x, y)[c] = filter->switches["hdr"] ? sum : sum / 2;
            }
    }
}
#endif

}  // extern "C"
