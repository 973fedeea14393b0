// SPDX-License-Identifier: Apache-2.0
// OpenEXR through its own library.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTileDescription.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <list>

#include "base/diagnostics.h"
#include "output/codec.h"

namespace sundog::output {
namespace {

class StringStream : public Imf::OStream {
public:
    StringStream() : OStream("picture") {}
    void write(const char data[], int size) override {
        const auto count = static_cast<std::size_t>(size);
        if (bytes.size() < position_ + count) bytes.resize(position_ + count);
        std::memcpy(bytes.data() + position_, data, count);
        position_ += count;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::string bytes;

private:
    std::size_t position_ = 0;
};

class BytesStream : public Imf::IStream {
public:
    explicit BytesStream(Bytes bytes) : IStream("picture"), bytes_(bytes) {}
    bool read(char data[], int size) override {
        const auto count = static_cast<std::size_t>(std::max(size, 0));
        if (position_ > bytes_.size() || count > bytes_.size() - position_)
            throw std::runtime_error("the file is cut off");
        std::memcpy(data, bytes_.data() + position_, count);
        position_ += count;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    Bytes bytes_;
    std::size_t position_ = 0;
};

std::uint32_t rounded_id(float value) {
    if (!(value > 0)) return 0;
    return value >= 0x1p32F ? 0xFFFFFFFFU : static_cast<std::uint32_t>(std::llround(value));
}

std::string write_exr(const Image& image, const std::vector<Layer>& layers) {
    const auto pixel_count = image.pixels.size();
    const auto width = static_cast<std::size_t>(image.width);
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer planes;
    // OpenEXR's frame buffers aren't const, though an output file only reads them.
    const auto add = [&](const std::string& name, Imf::PixelType type, const void* first, std::size_t stride) {
        if (header.channels().findChannel(name.c_str()) != nullptr)
            throw OutputError("can't write an EXR with two channels called '" + name + "'");
        header.channels().insert(name.c_str(), Imf::Channel(type));
        auto* base = static_cast<char*>(const_cast<void*>(first));
        planes.insert(name.c_str(), Imf::Slice(type, base, stride, stride * width));
    };
    add("R", Imf::FLOAT, &image.pixels[0].x, sizeof(Vec3));
    add("G", Imf::FLOAT, &image.pixels[0].y, sizeof(Vec3));
    add("B", Imf::FLOAT, &image.pixels[0].z, sizeof(Vec3));
    std::list<std::vector<std::uint32_t>> ids;
    for (const Layer& layer : layers) {
        const std::size_t channels = layer.channels.size();
        if (layer.values.size() != pixel_count * channels)
            throw OutputError("can't write the layer '" + layer.name + "': it is not of the picture's size");
        for (std::size_t c = 0; c < channels; ++c) {
            const std::string& channel = layer.channels[c];
            const std::string name = channel.empty() ? layer.name : layer.name + "." + channel;
            if (channel != "id") {
                add(name, Imf::FLOAT, layer.values.data() + c, channels * sizeof(float));
                continue;
            }
            std::vector<std::uint32_t>& plane = ids.emplace_back(pixel_count);
            for (std::size_t i = 0; i < pixel_count; ++i) plane[i] = rounded_id(layer.values[i * channels + c]);
            add(name, Imf::UINT, plane.data(), sizeof(std::uint32_t));
        }
    }
    StringStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(planes);
        file.writePixels(image.height);
    }  // Its destructor writes the table of where the lines begin.
    return std::move(stream.bytes);
}

/// The names of the channels to read as red, green and blue (or as brightness alone).
std::vector<std::string> colour_channels(const Imf::ChannelList& channels) {
    std::string names;
    for (auto c = channels.begin(); c != channels.end() && names.size() < 200; ++c) names.append(" ").append(c.name());
    std::vector<std::string> colour;
    const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
    if (has("R") && has("G") && has("B")) colour = {"R", "G", "B"};
    else if (has("Y") && !has("RY")) colour = {"Y"};
    else throw DecodeError("the EXR has neither channels R, G and B nor Y alone, but:" + names);
    for (const std::string& name : colour) {
        const Imf::Channel& channel = channels[name.c_str()];
        if (channel.xSampling != 1 || channel.ySampling != 1)
            throw DecodeError("the EXR's channel " + name + " is subsampled, which is not supported");
    }
    return colour;
}

Decoded read_exr(Bytes bytes, std::size_t bytes_per_pixel) {
    // The size is looked at before the library makes room for lines.
    constexpr std::size_t kMagicAndVersion = 8;
    {
        BytesStream stream(bytes);
        stream.seekg(kMagicAndVersion);
        Imf::Header header;
        int version = bytes.size() < kMagicAndVersion ? 0 : bytes[4];
        header.readFrom(stream, version);
        const Imath::Box2i window = header.dataWindow();
        const auto extent = [](int first, int last) {
            return last < first ? std::uint64_t{0} : static_cast<std::uint64_t>(std::int64_t{last} - first + 1);
        };
        check_size(extent(window.min.x, window.max.x), extent(window.min.y, window.max.y),
                   std::max(bytes_per_pixel, sizeof(Vec3)));
    }
    BytesStream stream(bytes);
    Imf::InputFile file(stream);
    const Imath::Box2i window = file.header().dataWindow();
    const std::vector<std::string> channels = colour_channels(file.header().channels());
    Decoded decoded;
    decoded.width = static_cast<std::uint32_t>(window.max.x - window.min.x + 1);
    decoded.height = static_cast<std::uint32_t>(window.max.y - window.min.y + 1);
    const std::size_t width = decoded.width;
    const std::size_t height = decoded.height;
    // Whole rows of tiles at once, or each tile would be decoded several times.
    std::size_t rows_at_once = 256;
    if (file.header().hasTileDescription())
        rows_at_once = std::max<std::size_t>(rows_at_once, file.header().tileDescription().ySize);
    for (std::size_t y = 0; y < height; y += rows_at_once) {
        const std::size_t rows = std::min(rows_at_once, height - y);
        grow(decoded.linear, (y + rows) * width, height * width);
        Vec3* first = decoded.linear.data() + y * width;
        Imf::FrameBuffer planes;
        const int first_row = window.min.y + static_cast<int>(y);
        const Imath::V2i origin(window.min.x, first_row);
        for (std::size_t c = 0; c < channels.size(); ++c)
            planes.insert(channels[c].c_str(),
                          Imf::Slice::Make(Imf::FLOAT, &(*first)[c], origin, static_cast<std::int64_t>(width),
                                           static_cast<std::int64_t>(rows), sizeof(Vec3), sizeof(Vec3) * width));
        file.setFrameBuffer(planes);
        file.readPixels(first_row, first_row + static_cast<int>(rows) - 1);
    }
    if (channels.size() == 1)
        for (Vec3& pixel : decoded.linear) pixel = {pixel.x, pixel.x, pixel.x};
    return decoded;
}

}  // namespace

std::string encode_exr(const Image& image, const std::vector<Layer>& layers) {
    try {
        return write_exr(image, layers);
    } catch (const OutputError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw OutputError(std::string("can't encode an EXR: ") + error.what());
    }
}

Decoded decode_exr(Bytes bytes, std::size_t bytes_per_pixel) {
    try {
        return read_exr(bytes, bytes_per_pixel);
    } catch (const DecodeError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw DecodeError(std::string("damaged EXR: ") + error.what());
    }
}

}  // namespace sundog::output
