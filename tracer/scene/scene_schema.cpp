#include "tracer/scene/read_scene.h"
#include "tracer/scene/scene_format.h"

#include <nlohmann/json.hpp>

namespace gnomon {

namespace {

using Json = nlohmann::ordered_json;

Json objectSchema(const ObjectFormat&);
Json wholeSchema(const ObjectFormat&);

Json numberSchema(Range range) {
    return {{"type", range.whole ? "integer" : "number"}, {"minimum", range.min}, {"maximum", range.max}};
}

Json tupleSchema(const Json& item, int count) {
    return {{"type", "array"}, {"items", item}, {"minItems", count}, {"maxItems", count}};
}

Json textSchema(Range range) {
    return {{"type", "string"}, {"minLength", int(range.min)}, {"maxLength", int(range.max)}};
}

/// Folders and a file, none of them empty, `.` or `..`; no backslash and no control character.
Json fileSchema(Range range, const char* noEnding = "") {
    Json schema = textSchema(range);
    schema["pattern"] = R"(^(?!\.{0,2}(/|$))(?!.*/\.{0,2}(/|$)))" + std::string(noEnding) + R"([^\\\x00-\x1f\x7f]+$)";
    return schema;
}

Json imageSchema(ValueType type) {
    return fileSchema(kImageName, type == ValueType::Panorama ? "" : R"((?!.*\.[hH][dD][rR]$))");
}

Json either(const Json& one, const Json& other) { return {{"anyOf", Json::array({one, other})}}; }

/// Sixteen points with their weights.
Json weightedSchema(const Json& number) {
    Json point = tupleSchema(number, 4);
    point["prefixItems"] = Json::array({number, number, number, numberSchema(kWeight)});
    return tupleSchema(point, 16);
}

Json listSchema(const FieldFormat& field) {
    return {{"type", "array"},
            {"minItems", int(field.range.min)},
            {"maxItems", int(field.range.max)},
            {"items", objectSchema(*field.format)}};
}

Json mapSchema(const FieldFormat& field) {
    return {{"type", "object"},
            {"propertyNames", textSchema(kName)},
            {"minProperties", int(field.range.min)},
            {"maxProperties", int(field.range.max)},
            {"additionalProperties", objectSchema(*field.format)}};
}

Json directionSchema(Range range) {
    Json schema = tupleSchema(numberSchema(range), 3);
    schema["not"] = {{"items", {{"const", 0}}}};
    return schema;
}

Json valueSchema(const FieldFormat& field) {
    const Json number = numberSchema(field.range);
    switch (field.type) {
    case ValueType::Boolean: return {{"type", "boolean"}};
    case ValueType::Number: return number;
    case ValueType::Scale: return either(number, tupleSchema(number, 2));
    case ValueType::Pair: return tupleSchema(number, 2);
    case ValueType::Vector: return tupleSchema(number, 3);
    case ValueType::Direction: return directionSchema(field.range);
    case ValueType::Color: return either(number, tupleSchema(number, 3));
    case ValueType::Colors: return tupleSchema(either(number, tupleSchema(number, 3)), 2);
    case ValueType::Vertices: return tupleSchema(tupleSchema(number, 3), 3);
    case ValueType::Numbers: return tupleSchema(number, 16);
    case ValueType::Points: return either(tupleSchema(tupleSchema(number, 3), 16), weightedSchema(number));
    case ValueType::Text: return textSchema(field.range);
    case ValueType::Image:
    case ValueType::Panorama: return imageSchema(field.type);
    case ValueType::File: return fileSchema(field.range);
    case ValueType::Scales: return either(number, tupleSchema(number, 3));
    case ValueType::Choice: return {{"enum", field.choices}};
    case ValueType::Object: return objectSchema(*field.format);
    case ValueType::ImageOrObject: return either(imageSchema(ValueType::Image), objectSchema(*field.format));
    case ValueType::List: return listSchema(field);
    case ValueType::Map: return mapSchema(field);
    case ValueType::Ignored: break;
    }
    return Json::object();
}

/// Exactly one of the keys, or at most one.
Json alternativesSchema(const Alternatives& group) {
    Json each = Json::array();
    for (std::string_view key : group.keys) each.push_back({{"required", Json::array({key})}});
    if (!group.required) {
        const Json none = {{"not", {{"anyOf", each}}}};
        each.push_back(none);
    }
    return {{"oneOf", each}};
}

Json exclusionSchema(const Exclusion& exclusion) {
    Json each = Json::array();
    for (std::string_view key : exclusion.others) each.push_back({{"required", Json::array({key})}});
    return {{"not", {{"required", Json::array({exclusion.key})}, {"anyOf", each}}}};
}

/// Named formats once, under $defs; elsewhere they are referred to.
Json objectSchema(const ObjectFormat& format) {
    return format.name.empty() ? wholeSchema(format) : Json{{"$ref", "#/$defs/" + std::string(format.name)}};
}

/// Every named format that can be reached from `format`.
void addDefinitions(const ObjectFormat& format, Json& definitions) {
    for (const FieldFormat& field : format.fields) {
        if (!field.format) continue;
        const std::string name(field.format->name);
        if (!name.empty() && definitions.contains(name)) continue;
        if (!name.empty()) definitions[name] = wholeSchema(*field.format);
        addDefinitions(*field.format, definitions);
    }
}

Json wholeSchema(const ObjectFormat& format) {
    Json schema = {{"type", "object"}};
    if (!format.help.empty()) schema["description"] = format.help;
    Json required = Json::array();
    Json properties = Json::object();
    for (const FieldFormat& field : format.fields) {
        Json property = {{"description", field.help}};
        const Json value = valueSchema(field);
        for (auto member = value.begin(); member != value.end(); ++member)
            if (member.key() != "description") property[member.key()] = member.value();
        properties[std::string(field.key)] = property;
        if (field.required) required.push_back(field.key);
    }
    schema["properties"] = properties;
    schema["additionalProperties"] = false;
    if (!required.empty()) schema["required"] = required;
    for (const Alternatives& group : format.alternatives) schema["allOf"].push_back(alternativesSchema(group));
    for (const Exclusion& exclusion : format.exclusions) schema["allOf"].push_back(exclusionSchema(exclusion));
    return schema;
}

} // namespace

std::string sceneSchema() {
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Gnomon scene"}};
    const Json scene = objectSchema(sceneFormat());
    for (auto member = scene.begin(); member != scene.end(); ++member) schema[member.key()] = member.value();
    addDefinitions(sceneFormat(), schema["$defs"]);
    return schema.dump(2) + "\n";
}

} // namespace gnomon
