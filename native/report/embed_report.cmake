# Writes OUTPUT: a C++ file with the text of FILES (separated by |) by their names without folder, and of MODULES as one
# script `report.js`: as they follow each other each has what it imports, so that imports and exports say nothing more.
string(REPLACE "|" ";" files "${FILES}")
string(REPLACE "|" ";" modules "${MODULES}")
set(body "")
function(add name text)
  string(APPEND body "    {\"${name}\", R\"__report__(${text})__report__\"},\n")
  set(body "${body}" PARENT_SCOPE)
endfunction()

foreach(file ${files})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  add(${name} "${text}")
endforeach()
set(script "")
foreach(file ${modules})
  file(READ ${file} text)
  string(REGEX REPLACE "\nimport [^\n]*" "" text "${text}")
  string(REGEX REPLACE "\nexport " "\n" text "${text}")
  string(APPEND script "${text}\n")
endforeach()
add(report.js "${script}")
file(WRITE ${OUTPUT} "#include \"native/report/report_files.h\"

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
