# Writes OUTPUT: a C++ file with the text of FILES (separated by |), by their names without folder.
string(REPLACE "|" ";" files "${FILES}")
set(body "")
foreach(file ${files})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND body "    {\"${name}\", R\"__report__(${text})__report__\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"native/report_files.h\"

namespace gnomon {
namespace {
struct File {
    std::string_view name, text;
};
constexpr File kFiles[] = {
${body}};
} // namespace

std::string_view reportFile(std::string_view name) {
    for (const File& file : kFiles)
        if (file.name == name) return file.text;
    return {};
}
} // namespace gnomon
")
