// SPDX-License-Identifier: Apache-2.0
#include "command_line.h"

#include <algorithm>
#include <cstdlib>

#include "../usage_error.h"
#include "base/paths.h"
#include "base/text_file.h"
#include "ini_file.h"
#include "option_table.h"
#include "switches.h"

namespace sundog::app {
namespace {

namespace fs = std::filesystem;

/// INI files within INI files, as deep as the tutorial allows.
constexpr int kDeepestIni = 10;

/// `res[Med]` names the section Med of the file res.
struct IniName {
    std::string file, label;
};
IniName split_label(std::string_view word) {
    const std::size_t open = word.find('[');
    if (open == std::string_view::npos || !word.ends_with(']')) return {std::string(without_quotes(word)), {}};
    return {std::string(without_quotes(word.substr(0, open))),
            std::string(word.substr(open + 1, word.size() - open - 2))};
}

bool names_scene(std::string_view name) { return lower_case(name).ends_with(".pov"); }

class Reader {
public:
    Reader(const PovSurroundings& surroundings, const WarningSink& warn) : surroundings_(surroundings), warn_(warn) {}

    void read_default_ini() {
        if (surroundings_.povini) {
            if (is_file(*surroundings_.povini)) {
                read_ini(*surroundings_.povini, {});
                return;
            }
            warn("the file that POVINI names isn't there: " + in_quotes(surroundings_.povini->string()));
        }
        std::vector<fs::path> candidates{surroundings_.working_folder / "povray.ini"};
        if (!surroundings_.home.empty()) {
            candidates.push_back(surroundings_.home / ".povray/3.7/povray.ini");
            candidates.push_back(surroundings_.home / ".povrayrc");
        }
        candidates.insert(candidates.end(), surroundings_.system_inis.begin(), surroundings_.system_inis.end());
        const auto found = std::find_if(candidates.begin(), candidates.end(), is_file);
        if (found != candidates.end()) read_ini(*found, {});
    }

    void read_words(const std::vector<std::string>& words) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            try {
                if (words[i].starts_with("--")) i += read_own_switch(words, i);
                else read_word(words[i], words.size() == 1);
            } catch (const OptionError& error) {
                throw UsageError(error.what(), error.hint());
            }
        }
    }

    PovSettings settings;

private:
    void warn(std::string message) const {
        Diagnostic diagnostic;
        diagnostic.severity = Severity::warning;
        diagnostic.message = std::move(message);
        if (warn_) warn_(diagnostic);
    }

    void read_word(const std::string& word, bool alone) {
        const std::string lower = lower_case(word);
        if (lower == "-?" || lower == "+?" || lower == "-h" || lower == "-help" || (alone && lower == "+h")) {
            settings.wanted = PovSettings::Wanted::help;
        } else if (lower == "-version") {
            settings.wanted = PovSettings::Wanted::version;
        } else if (word.starts_with('+') || (word.starts_with('-') && word != "-")) {
            apply_switch(word, true);
        } else if (const std::size_t equals = word.find('='); equals != std::string::npos) {
            const OptionText option{std::string(trimmed(std::string_view(word).substr(0, equals))),
                                    word.substr(equals + 1), true};
            apply(option);
        } else {
            read_file_word(word);
        }
    }

    /// Sundog's own. Returns how many further words it took.
    std::size_t read_own_switch(const std::vector<std::string>& words, std::size_t at) {
        const std::string& word = words[at];
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        if (name == "--help") {
            settings.wanted = PovSettings::Wanted::help;
            return 0;
        }
        if (name == "--version") {
            settings.wanted = PovSettings::Wanted::version;
            return 0;
        }
        if (name == "--format" && equals == std::string::npos) {
            settings.wanted = PovSettings::Wanted::formatted;
            return 0;
        }
        if (name == "--sandbox" && equals == std::string::npos) {
            settings.sandbox = true;
            return 0;
        }
        constexpr std::string_view kNames[] = {"--help",        "--version",   "--format",     "--sandbox",
                                               "--allow-write", "--max-steps", "--max-memory", "--device"};
        if (std::find(std::begin(kNames), std::end(kNames), name) == std::end(kNames) || name == "--sandbox" ||
            name == "--format")
            throw UsageError("there is no switch " + in_quotes(word), suggest(name, kNames));
        const bool apart = equals == std::string::npos;
        if (apart && at + 1 == words.size()) throw UsageError("the switch " + name + " needs a value");
        const std::string value = apart ? words[at + 1] : word.substr(equals + 1);
        if (name == "--allow-write") settings.allow_write.push_back(value);
        else if (name == "--device") settings.device = value;
        else (name == "--max-steps" ? settings.max_steps : settings.max_memory_mb) = count(name, value);
        return apart ? 1 : 0;
    }

    static std::uint64_t count(const std::string& name, const std::string& value) {
        // 15 digits are far more than any machine works through, and never overflow.
        const bool digits = std::all_of(value.begin(), value.end(), [](char c) { return c >= '0' && c <= '9'; });
        if (value.empty() || value.size() > 15 || !digits || std::stoull(value) == 0)
            throw UsageError(name + " can't be " + in_quotes(value), "expected a whole number from 1");
        return std::stoull(value);
    }

    void apply(const OptionText& option) {
        apply_option(settings, option);
        if (option.from_command_line && lower_case(option.name) == "input_file_name") name_folder(settings.input_file);
    }

    void apply_switch(std::string_view word, bool from_command_line) {
        for (const OptionText& option : options_of_switch(word, from_command_line)) apply(option);
    }

    void set_input(const std::string& name, bool from_command_line) {
        apply({"Input_File_Name", name, from_command_line});
    }

    void name_folder(const fs::path& file) {
        settings.command_line_folders.push_back((surroundings_.working_folder / file).parent_path());
    }

    /// An INI file as it lies in the working folder or a library path; empty where there is none.
    [[nodiscard]] fs::path find_ini(const std::string& name) const {
        std::vector<fs::path> folders{surroundings_.working_folder};
        for (const std::string& path : settings.library_paths) folders.push_back(surroundings_.working_folder / path);
        for (const fs::path& folder : folders)
            for (const char* ending : {"", ".ini", ".INI"})
                if (fs::path file = folder / (name + ending); is_file(file)) return file;
        return {};
    }

    void read_file_word(const std::string& word) {
        const IniName name = split_label(word);
        if (name.label.empty() && (names_scene(name.file) || name.file == "-")) {
            set_input(name.file, true);
            return;
        }
        if (const fs::path file = find_ini(name.file); !file.empty()) {
            name_folder(file);
            read_ini(file, name.label);
            return;
        }
        // povray knows no bare scene without its ending; nothing else can be meant here, though.
        if (name.label.empty() && is_file(surroundings_.working_folder / (name.file + ".pov"))) {
            set_input(name.file + ".pov", true);
            return;
        }
        throw UsageError("there is no INI file " + in_quotes(name.file),
                         "a scene's name ends in .pov or follows +I; a switch begins with + or -");
    }

    void read_ini(const fs::path& file, const std::string& label) {
        if (ini_depth_ == kDeepestIni)
            fail_file(std::make_shared<const std::string>(file.string()), "INI files name each other too deeply",
                      "at most " + std::to_string(kDeepestIni) + " within each other");
        ++ini_depth_;
        const bool found = visit_ini_file(file, label, [&](const IniLine& line, LineCursor& cursor) {
            try {
                read_ini_line(line, cursor);
            } catch (const OptionError& error) {
                cursor.fail(cursor.here(), error.what(), error.hint());
            }
        });
        --ini_depth_;
        if (!found) warn("there is no section [" + label + "] in " + in_quotes(file.string()));
    }

    void read_ini_line(const IniLine& line, LineCursor& cursor) {
        switch (line.kind) {
            case IniLine::Kind::option:
                apply({line.name, line.value, false});
                break;
            case IniLine::Kind::switches:
                for (const std::string& word : line.words) {
                    if (!word.starts_with('+') && !word.starts_with('-'))
                        throw OptionError("expected a switch here, not " + in_quotes(word));
                    apply_switch(word, false);
                }
                break;
            case IniLine::Kind::file: {
                const IniName name = split_label(line.name);
                if (name.label.empty() && names_scene(name.file)) {
                    set_input(name.file, false);
                    break;
                }
                const fs::path file = find_ini(name.file);
                if (file.empty())
                    cursor.fail(cursor.here(), "there is no INI file " + in_quotes(name.file),
                                "expected Option=value, a switch or an INI file's name");
                read_ini(file, name.label);
            }
        }
    }

    const PovSurroundings& surroundings_;
    const WarningSink& warn_;
    int ini_depth_ = 0;
};

}  // namespace

PovSurroundings surroundings_of_process() {
    PovSurroundings surroundings;
    std::error_code ignored;
    surroundings.working_folder = fs::current_path(ignored);
    if (const char* povini = std::getenv("POVINI"); povini && *povini) surroundings.povini = povini;
    if (const char* home = std::getenv("HOME")) surroundings.home = home;
    surroundings.system_inis = {"/usr/local/etc/povray/3.7/povray.ini", "/etc/povray/3.7/povray.ini",
                                "/etc/povray.ini"};
    return surroundings;
}

PovSettings read_command_line(const std::vector<std::string>& words, const PovSurroundings& surroundings,
                              const WarningSink& warn) {
    Reader reader(surroundings, warn);
    reader.read_default_ini();
    reader.read_words(words);
    return std::move(reader.settings);
}

}  // namespace sundog::app
