# Writes OUTPUT: a C++ file with the text of every shader file under ROOT, sorted by name, as FUNCTION that HEADER declares.
# PREFIX comes before each name.
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/*.glsl ${ROOT}/*.frag ${ROOT}/*.vert)
list(SORT files)
set(body "")
foreach(name ${files})
  file(READ ${ROOT}/${name} text)
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
