/// The one table of settings. Keys, command line, URL, panels, `--help`, `gnomon settings` and the README's table are
/// all made from it. Adding a setting is a member of Settings and one row in settings_table.cpp.
#pragma once

#include "tracer/problem.h"
#include "tracer/settings/shadow_models.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gnomon {

/// Which end shadow cones are marched from.
enum class ConeOrigin { Surface, Light };

/// How rays find the surface of a distance object.
enum class March { Steps, Sphere, Cone, Relaxed };

/// Outputs of the shader, see `--aov` in docs/outputs.md.
enum class Aov { Color, Distance, Position, Normal, Object, Visibility, Work, Steps };
/// Floats a pixel of an output: 3 for vectors and colours, 1 otherwise.
int channelsOf(Aov);

/// Where the shader reads the scene from.
enum class DataPath { Auto, Block, Texture };

/// Acceleration structure: none, a hierarchy of boxes, or what costs less.
enum class Accel { Auto, None, Hierarchy };

/// Whether base variants of the shader draw the pixels that need no uncommon feature: on a software rasteriser only,
/// always, never.
enum class Variants { Auto, On, Off };

/// How rays find parametric surfaces: in a baked field of their distance, or as they are.
enum class SurfaceMode { Field, Patch };
/// How distances to such a surface are worked out: exactly, or by one of the third source's ways.
enum class FieldMethod { Exact, Adamax, Adam, Gradient, Brute, Lipschitz };
enum class FieldFormat { R32f, R16f };
/// How rays go through a field.
enum class FieldMarch { Sphere, Relaxed, Voxel };

/// All settings with their defaults. What is optional and unset comes from the scene.
struct Settings {
    int depth = 4;
    double threshold = 1.0 / 512.0;
    ShadowModel shadows = ShadowModel::Hard;
    double epsilon = 1.0 / 30;
    int shadowSteps = 256;
    ConeOrigin coneOrigin = ConeOrigin::Surface;
    int samples = 64, firstSample = 0;
    std::optional<double> lightRadius;
    March march = March::Cone;
    int marchSteps = 256;
    SurfaceMode surface = SurfaceMode::Patch;
    FieldMethod fieldMethod = FieldMethod::Exact;
    int fieldResolution = 64; ///< samples along each axis
    FieldFormat fieldFormat = FieldFormat::R32f;
    int fieldIterations = 25, fieldStarts = 10;                    ///< of the descents
    double fieldRate = 0.005, fieldBeta1 = 0.9, fieldBeta2 = 0.99; ///< of these, too
    int fieldSamples = 64;                                         ///< that brute force takes along u and v
    double lipschitz = 0;                                          ///< 0: what bounds the slope of each surface
    FieldMarch fieldMarch = FieldMarch::Sphere;
    int fieldSteps = 256;
    double fieldEpsilon = 0.001, fieldRelaxation = 1.4;
    bool glow = true;
    bool normalMaps = true;
    int colorMode = 5; ///< index into colorModes(): 5 = rgb
    Aov aov = Aov::Color;
    int light = 0;
    double time = 0;
    bool pause = false;
    std::optional<glm::dvec3> eye, target;
    std::optional<double> fov;
    double speed = 10;
    glm::ivec2 size{800, 600};
    double scale = 1;
    bool adapt = true;
    bool vsync = true;
    Accel accel = Accel::Auto;
    DataPath data = DataPath::Auto;
    Variants variants = Variants::Auto;

    bool operator==(const Settings&) const = default;
};

/// What a change of a setting asks of the renderer.
enum class Effect { Uniform, Rebuild, Bake, Resize, Host };

struct BoolType {
    bool Settings::*at;
};
struct IntType {
    int Settings::*at;
    int min, max;
};
struct RealType {
    double Settings::*at;
    double min, max;
};
struct OptionalRealType {
    std::optional<double> Settings::*at;
    double min, max;
};
struct OptionalPointType {
    std::optional<glm::dvec3> Settings::*at;
    double limit;
};
struct SizeType {
    glm::ivec2 Settings::*at;
    int min, max;   ///< of each side
    int megapixels; ///< at most, so many times 1024 x 1024
};
/// An earlier name and the present one: read as this, never written.
struct Renamed {
    std::string_view was, is;
};
/// `name` as it is called at present.
std::string_view renamed(std::string_view name, std::span<const Renamed>);

struct ChoiceType {
    std::vector<std::string_view> names;
    int (*get)(const Settings&);
    void (*set)(Settings&, int);
    std::vector<Renamed> renamed{};
    bool switches = false; ///< a hotkey goes to the first choice, and from there to the second: off and on
};
using SettingType =
    std::variant<BoolType, IntType, RealType, OptionalRealType, OptionalPointType, SizeType, ChoiceType>;

struct SettingRow {
    std::string_view key; ///< on the command line and in URLs, as `normal-maps`
    SettingType type;
    std::string_view group;
    std::string_view help;
    Effect effect = Effect::Uniform;
    double step = 0;            ///< for sliders; 0: none
    std::string_view next = {}; ///< hotkey: switches, or goes one on; names as keyName() gives them
    std::string_view previous = {};
    std::vector<std::string_view> aliases = {}; ///< earlier keys: understood wherever a key is read, never written
};

std::span<const SettingRow> settingsTable();
/// By its key or an alias; null where there is none.
const SettingRow* findSetting(std::string_view key);

/// The 27 channel triples rrr … bbb.
std::span<const std::string_view> colorModes();

/// The shortest decimal text that reads back as `value`.
std::string numberText(double value);
/// The setting's value as text, such that setFromText gives it back; empty for an optional that is unset.
std::string textOf(const SettingRow&, const Settings&);
/// Values the setting takes, for people: `1…8`, `on|off`, `off|hard`.
std::string rangeOf(const SettingRow&);
/// Sets one setting from text. False, with a problem that names key, range and remedy, and nothing changed, where that
/// cannot be. `source` is the problem's file: `command line`, `URL`, ….
bool setFromText(Settings&, std::string_view key, std::string_view text, std::string_view source, Problems&);

/// As who gives settings at `source` writes the key: `--depth` on the command line.
std::string spelled(std::string_view source, std::string_view key);

/// Applies a hotkey. Answers what to tell the user (`depth 5`), empty where the key is no setting's.
std::string pressHotkey(Settings&, std::string_view key);

/// `key=value` pairs joined by `&`, only what differs from the defaults.
std::string toUrlQuery(const Settings&);
/// The table itself as JSON, a list of rows: key, aliases (where it has some), type (bool, int, real, point, size,
/// choice), default (null: the scene's), min and max or names and renamed (earlier names, where there are some), range
/// (for people), step (where it has one), group, help, hotkeys [next, previous], effect.
std::string settingsJson();
/// The table itself as the README shows it.
std::string settingsMarkdown();

} // namespace gnomon
