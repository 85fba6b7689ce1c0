#include "tracer/settings/settings.h"

#include <algorithm>

namespace gnomon {

namespace {

/// Goes one on or back; answers what stands in the way, as `the most`.
struct Step {
    Settings& settings;
    int by;

    std::string operator()(const BoolType& type) {
        settings.*type.at = !(settings.*type.at);
        return {};
    }
    std::string operator()(const IntType& type) {
        const int wanted = settings.*type.at + by;
        settings.*type.at = std::min(std::max(wanted, type.min), type.max);
        return wanted > type.max ? "the most" : wanted < type.min ? "the least" : "";
    }
    std::string operator()(const ChoiceType& type) {
        const int count = int(type.names.size());
        if (type.switches) return type.set(settings, type.get(settings) == 0), std::string();
        type.set(settings, (type.get(settings) + by + count) % count);
        return {};
    }
    template<class Other>
    std::string operator()(const Other&) {
        return {};
    } // numbers and points have no hotkeys
};

} // namespace

std::string pressHotkey(Settings& settings, std::string_view key) {
    for (const auto& row : settingsTable()) {
        if (key.empty() || (row.next != key && row.previous != key)) continue;
        const std::string stop = std::visit(Step{settings, row.next == key ? 1 : -1}, row.type);
        return std::string(row.key) + " " + textOf(row, settings) + (stop.empty() ? "" : ", " + stop);
    }
    return {};
}

} // namespace gnomon
