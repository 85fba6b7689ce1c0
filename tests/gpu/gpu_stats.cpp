// What the compiler of a real GPU makes of a fragment shader, on a machine without that GPU: registers, spills,
// scratch, occupancy. scripts/gpu-stats writes the SPIR-V and calls this.
//
// usage: gpu_stats FAMILY,… VERTEX.spv RESULTS.json|- COMMAND "SCENE SETTINGS=FRAGMENT.spv" …
//
// Mesa's RADV compiles for any family that RADV_FORCE_FAMILY names, without a device;
// VK_KHR_pipeline_executable_properties says what came out. A family ending in /32 takes waves of 32 for pixels, as
// radeonsi does for shaders without inputs.
#include "lab/results/results.h"

#include <vulkan/vulkan.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using gnomon::Cell;
using Words = std::vector<uint32_t>;

void check(VkResult result, const std::string& what) {
    if (result != VK_SUCCESS) throw std::runtime_error(what + ": VkResult " + std::to_string(result));
}

/// A number of the compiler's, under the name that RADV gives it.
struct Figure {
    const char* radv;
    gnomon::Column column;
};

const Figure kFigures[] = {
    {"Subgroups per SIMD",
     {"occupancy", "occupancy", "waves",
      "Waves that a SIMD holds at once, what hides latency; on RDNA a wave of 64 counts as two"}},
    {"VGPRs", {"vgprs", "VGPRs", "", "Vector registers a wave takes"}},
    {"SGPRs", {"sgprs", "SGPRs", "", "Scalar registers a wave takes"}},
    {"Spilled VGPRs", {"spilled_vgprs", "spilled VGPRs", "", "Vector registers put aside to memory"}},
    {"Spilled SGPRs", {"spilled_sgprs", "spilled SGPRs", "", "Scalar registers put aside to vector registers"}},
    {"Scratch size", {"scratch", "scratch", "B", "Memory a wave takes for arrays and spilled registers"}},
    {"LDS size", {"lds", "LDS", "B", "Local data share"}},
    {"Code size", {"code", "code", "B", "Machine code"}},
    {"Instructions", {"instructions", "instructions", "", "In the code, not as executed"}},
    {"Branches", {"branches", "branches", "", "Instructions that may jump"}},
    {"Latency", {"latency", "latency", "cycles", "RADV's estimate for one wave on its own"}},
    {"Inverse Throughput",
     {"throughput", "inverse throughput", "cycles", "RADV's estimate of the cycles a wave costs on a full GPU"}},
};

Words readSpirv(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    if (bytes.size() < 20 || bytes.size() % 4 != 0) throw std::runtime_error(path + ": no SPIR-V");
    Words words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

/// What a pipeline has to know of a fragment shader from outside.
struct Interface {
    std::vector<VkDescriptorSetLayoutBinding> bindings; ///< of set 0
    int outputs = 0;
};

Interface interfaceOf(const Words& spirv) {
    constexpr uint32_t kOpVariable = 59, kOpDecorate = 71; // numbers of the SPIR-V specification
    constexpr uint32_t kLocation = 30, kBinding = 33, kUniformConstant = 0, kUniform = 2, kOutput = 3;
    std::map<uint32_t, uint32_t> bindingOf, locationOf;
    Interface interface;
    for (size_t at = 5; at < spirv.size(); at += std::max(spirv[at] >> 16, 1u)) {
        const uint32_t* word = &spirv[at];
        const uint32_t op = word[0] & 0xFFFF;
        if (op == kOpDecorate && word[2] == kBinding) bindingOf[word[1]] = word[3];
        if (op == kOpDecorate && word[2] == kLocation) locationOf[word[1]] = word[3];
        if (op != kOpVariable) continue;
        if (word[3] == kOutput && locationOf.count(word[2])) ++interface.outputs;
        if (!bindingOf.count(word[2]) || (word[3] != kUniform && word[3] != kUniformConstant)) continue;
        const auto type =
            word[3] == kUniform ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        interface.bindings.push_back({bindingOf[word[2]], type, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr});
    }
    return interface;
}

/// The compiler for one family of GPUs.
class Compiler {
  public:
    explicit Compiler(const std::string& family);
    ~Compiler();
    Compiler(const Compiler&) = delete;
    Compiler& operator=(const Compiler&) = delete;

    /// The figures of the fragment shader by RADV's names; its wave's size under "wave".
    std::map<std::string, double> figures(const Words& vertex, const Words& fragment) const;
    const std::string& name() const { return m_name; }

  private:
    VkShaderModule module(const Words& spirv) const;
    VkPipelineLayout layout(const Interface&, VkDescriptorSetLayout&) const;
    VkPipeline pipeline(VkShaderModule vertex, VkShaderModule fragment, VkPipelineLayout, int outputs) const;
    std::map<std::string, double> read(VkPipeline) const;

    template<class Function>
    Function function(const char* called) const {
        return reinterpret_cast<Function>(vkGetDeviceProcAddr(m_device, called));
    }

    VkInstance m_instance = VK_NULL_HANDLE;
    VkPhysicalDevice m_physical = VK_NULL_HANDLE;
    VkDevice m_device = VK_NULL_HANDLE;
    std::string m_name;
};

Compiler::Compiler(const std::string& family) {
    const auto slash = family.find('/');
    const std::string chip = family.substr(0, slash);
    setenv("RADV_FORCE_FAMILY", chip.c_str(), 1);
    setenv("RADV_PERFTEST", slash == std::string::npos ? "" : "pswave32", 1);

    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo instance{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    instance.pApplicationInfo = &application;
    check(vkCreateInstance(&instance, nullptr, &m_instance), "no Vulkan driver (mesa-vulkan-drivers)");
    uint32_t count = 1;
    vkEnumeratePhysicalDevices(m_instance, &count, &m_physical);
    if (count == 0 || !m_physical) throw std::runtime_error("RADV knows no family '" + chip + "'");
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(m_physical, &properties);
    m_name = properties.deviceName;

    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executables{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR, nullptr, VK_TRUE};
    VkPhysicalDeviceVulkan13Features features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES, &executables};
    features.dynamicRendering = VK_TRUE;
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    VkDeviceCreateInfo device{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features};
    device.queueCreateInfoCount = 1;
    device.pQueueCreateInfos = &queue;
    device.enabledExtensionCount = 1;
    device.ppEnabledExtensionNames = &extension;
    check(vkCreateDevice(m_physical, &device, nullptr, &m_device), m_name + ": no device");
}

Compiler::~Compiler() {
    if (m_device) vkDestroyDevice(m_device, nullptr);
    if (m_instance) vkDestroyInstance(m_instance, nullptr);
}

VkShaderModule Compiler::module(const Words& spirv) const {
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = spirv.size() * 4;
    info.pCode = spirv.data();
    VkShaderModule made;
    check(vkCreateShaderModule(m_device, &info, nullptr, &made), "shader module");
    return made;
}

VkPipelineLayout Compiler::layout(const Interface& interface, VkDescriptorSetLayout& set) const {
    VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    setInfo.bindingCount = uint32_t(interface.bindings.size());
    setInfo.pBindings = interface.bindings.data();
    check(vkCreateDescriptorSetLayout(m_device, &setInfo, nullptr, &set), "descriptor set layout");
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = 1;
    info.pSetLayouts = &set;
    VkPipelineLayout made;
    check(vkCreatePipelineLayout(m_device, &info, nullptr, &made), "pipeline layout");
    return made;
}

VkPipeline Compiler::pipeline(VkShaderModule vertex, VkShaderModule fragment, VkPipelineLayout layout,
                              int outputs) const {
    VkPipelineShaderStageCreateInfo stages[2] = {{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO},
                                                 {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO}};
    stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
    stages[0].module = vertex;
    stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
    stages[1].module = fragment;
    stages[0].pName = stages[1].pName = "main";

    const VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    const VkViewport view{0, 0, 800, 600, 0, 1};
    const VkRect2D scissor{{0, 0}, {800, 600}};
    const VkPipelineViewportStateCreateInfo viewport{
        VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, nullptr, 0, 1, &view, 1, &scissor};
    VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    raster.lineWidth = 1;
    VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineColorBlendAttachmentState write{};
    write.colorWriteMask = 0xF;
    const std::vector<VkPipelineColorBlendAttachmentState> writes(size_t(outputs), write);
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = uint32_t(outputs);
    blend.pAttachments = writes.data();
    // The first output is what is shown; any further ones hold numbers.
    std::vector<VkFormat> formats(size_t(outputs), VK_FORMAT_R32G32B32A32_SFLOAT);
    if (outputs > 0) formats[0] = VK_FORMAT_R8G8B8A8_UNORM;
    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
    rendering.colorAttachmentCount = uint32_t(outputs);
    rendering.pColorAttachmentFormats = formats.data();

    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
    info.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
    info.stageCount = 2;
    info.pStages = stages;
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pColorBlendState = &blend;
    info.layout = layout;
    VkPipeline made;
    check(vkCreateGraphicsPipelines(m_device, VK_NULL_HANDLE, 1, &info, nullptr, &made), m_name + ": pipeline");
    return made;
}

double numberOf(const VkPipelineExecutableStatisticKHR& statistic) {
    switch (statistic.format) {
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR: return statistic.value.b32;
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR: return double(statistic.value.i64);
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_FLOAT64_KHR: return statistic.value.f64;
    default: return double(statistic.value.u64);
    }
}

std::map<std::string, double> Compiler::read(VkPipeline pipeline) const {
    const auto propertiesOf =
        function<PFN_vkGetPipelineExecutablePropertiesKHR>("vkGetPipelineExecutablePropertiesKHR");
    const auto statisticsOf =
        function<PFN_vkGetPipelineExecutableStatisticsKHR>("vkGetPipelineExecutableStatisticsKHR");
    const VkPipelineInfoKHR which{VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, nullptr, pipeline};
    uint32_t count = 0;
    check(propertiesOf(m_device, &which, &count, nullptr), "executables");
    std::vector<VkPipelineExecutablePropertiesKHR> executables(count,
                                                               {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR});
    check(propertiesOf(m_device, &which, &count, executables.data()), "executables");
    for (uint32_t i = 0; i < count; ++i) {
        if (!(executables[i].stages & VK_SHADER_STAGE_FRAGMENT_BIT)) continue;
        const VkPipelineExecutableInfoKHR one{VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR, nullptr, pipeline, i};
        uint32_t size = 0;
        check(statisticsOf(m_device, &one, &size, nullptr), "statistics");
        std::vector<VkPipelineExecutableStatisticKHR> statistics(size,
                                                                 {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR});
        check(statisticsOf(m_device, &one, &size, statistics.data()), "statistics");
        std::map<std::string, double> figures{{"wave", executables[i].subgroupSize}};
        for (const auto& statistic : statistics) figures[statistic.name] = numberOf(statistic);
        return figures;
    }
    throw std::runtime_error(m_name + ": the pipeline has no fragment shader");
}

std::map<std::string, double> Compiler::figures(const Words& vertexSpirv, const Words& fragmentSpirv) const {
    const Interface interface = interfaceOf(fragmentSpirv);
    const VkShaderModule vertex = module(vertexSpirv), fragment = module(fragmentSpirv);
    VkDescriptorSetLayout set;
    const VkPipelineLayout pipelineLayout = layout(interface, set);
    const VkPipeline made = pipeline(vertex, fragment, pipelineLayout, interface.outputs);
    auto found = read(made);
    vkDestroyPipeline(m_device, made, nullptr);
    vkDestroyPipelineLayout(m_device, pipelineLayout, nullptr);
    vkDestroyDescriptorSetLayout(m_device, set, nullptr);
    vkDestroyShaderModule(m_device, fragment, nullptr);
    vkDestroyShaderModule(m_device, vertex, nullptr);
    return found;
}

gnomon::Table emptyTable() {
    gnomon::Table table{"gpu", "The shader as GPUs run it", {}, {}, 3};
    table.columns = {{"family", "family", "", "Chip that RADV compiled for"},
                     {"scene", "scene", "", "Scene file"},
                     {"settings", "settings", "", "Settings that differ from the defaults"},
                     {"wave", "wave", "lanes", "Pixels that run together"}};
    for (const Figure& figure : kFigures) {
        table.columns.push_back(figure.column);
        table.columns.back().kind = gnomon::Kind::Count;
    }
    return table;
}

std::vector<Cell> rowOf(const std::string& family, const std::string& shader,
                        const std::map<std::string, double>& figures) {
    const auto space = shader.find(' ');
    std::vector<Cell> row{family, shader.substr(0, space)};
    row.emplace_back(space == std::string::npos ? std::string() : shader.substr(space + 1));
    row.emplace_back(figures.at("wave"));
    for (const Figure& figure : kFigures) {
        const auto found = figures.find(figure.radv);
        if (found == figures.end())
            row.emplace_back();
        else
            row.emplace_back(found->second);
    }
    return row;
}

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> parts;
    for (size_t from = 0; from <= list.size();) {
        const size_t comma = std::min(list.find(',', from), list.size());
        parts.push_back(list.substr(from, comma - from));
        from = comma + 1;
    }
    return parts;
}

void measure(gnomon::Results& results, const std::string& family, const Words& vertex,
             const std::vector<std::string>& shaders) {
    const Compiler compiler(family);
    results.environment.push_back({family, compiler.name()});
    for (size_t i = 0; i < shaders.size(); ++i) {
        const size_t equals = shaders[i].rfind('=');
        const std::string shader = shaders[i].substr(0, equals);
        if (isatty(2))
            std::fprintf(stderr, "\r%s: %zu of %zu  %-50.50s", family.c_str(), i + 1, shaders.size(), shader.c_str());
        results.tables[0].rows.push_back(
            rowOf(family, shader, compiler.figures(vertex, readSpirv(shaders[i].substr(equals + 1)))));
    }
    if (isatty(2)) std::fprintf(stderr, "\r%70s\r", "");
}

int run(const std::vector<std::string>& arguments) {
    gnomon::Results results{"What GPUs make of the shader", arguments[3], {}, {emptyTable()}, {}};
    const Words vertex = readSpirv(arguments[1]);
    for (const std::string& family : split(arguments[0]))
        measure(results, family, vertex, {arguments.begin() + 4, arguments.end()});
    if (arguments[2] == "-") {
        std::fputs(gnomon::toMarkdown(results.tables[0]).c_str(), stdout);
        return 0;
    }
    std::ofstream file(arguments[2], std::ios::binary);
    file << gnomon::toJson(results);
    file.close();
    if (!file) throw std::runtime_error("cannot write " + arguments[2]);
    return 0;
}

} // namespace

int main(int count, char** values) try {
    if (count < 6)
        throw std::runtime_error("wants FAMILIES VERTEX.spv RESULTS|- COMMAND SHADER…; call scripts/gpu-stats");
    return run({values + 1, values + count});
} catch (const std::exception& problem) {
    std::fprintf(stderr, "gpu_stats: error: %s\n", problem.what());
    return 1;
}
