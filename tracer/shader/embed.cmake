# Writes OUTPUT: a C++ file with the text of every one of FILES, which lie under ROOT, sorted by name, as FUNCTION that
# HEADER declares. PREFIX comes before each name, which is relative to ROOT. Comments stay behind, their lines do not,
# so that a driver's complaint finds its place: the page would carry them for nobody. With PLAIN=ON indentation stays
# behind, too.
list(SORT FILES)
set(body "")
foreach(file ${FILES})
  file(RELATIVE_PATH name ${ROOT} ${file})
  file(READ ${ROOT}/${name} text)
  string(REGEX REPLACE "[ \t]*//[^\n]*" "" text "${text}")
  if(PLAIN)
    string(REGEX REPLACE "\n +" "\n" text "${text}")
  endif()
  string(APPEND body "    {\"${PREFIX}${name}\", R\"__glsl__(${text})__glsl__\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"${HEADER}\"

namespace gnomon {
namespace {
constexpr ShaderFile kFiles[] = {
${body}};
}

std::span<const ShaderFile> ${FUNCTION}() { return kFiles; }
} // namespace gnomon
")
