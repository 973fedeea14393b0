// SPDX-License-Identifier: Apache-2.0
#include "machine.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <thread>

namespace sundog::bench {

namespace {

std::string read_text(const char* file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

}  // namespace

std::string field_of(const std::string& text, const std::string& key) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(key)) continue;
        const std::size_t colon = line.find(':');
        if (colon == std::string::npos || line.find_first_not_of(" \t", key.size()) != colon) continue;
        const std::size_t start = line.find_first_not_of(" \t", colon + 1);
        return start == std::string::npos ? std::string() : line.substr(start);
    }
    return {};
}

std::string machine_name() {
    std::string processor = field_of(read_text("/proc/cpuinfo"), "model name");
    if (processor.empty()) processor = "unknown processor";
    const std::string memory = field_of(read_text("/proc/meminfo"), "MemTotal");
    const double memory_kib = memory.empty() ? 0 : std::stod(memory);
    return fmt::format("{}, {} hardware threads, {:.0f} GiB", processor, std::thread::hardware_concurrency(),
                       memory_kib / (1024.0 * 1024.0));
}

}  // namespace sundog::bench
