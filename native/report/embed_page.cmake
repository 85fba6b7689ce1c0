# Writes OUTPUT: a C++ file with the page PAGE, in which the marks STYLE, CHART and the modules of MODULES (separated by
# |) stand as text. Modules become one script: as they follow each other each has what it imports, so that imports and
# exports say nothing more. The page's policy names what may run by its hash.
string(REPLACE "|" ";" modules "${MODULES}")
file(READ ${PAGE} page)
file(READ ${STYLE} style)
file(READ ${CHART} chart)
set(script "")
foreach(file ${modules})
  file(READ ${file} text)
  string(REGEX REPLACE "\nimport [^\n]*" "" text "${text}")
  string(REGEX REPLACE "\nexport " "\n" text "${text}")
  string(APPEND script "${text}\n")
endforeach()
string(REPLACE "/*style*/" "${style}" page "${page}")
string(REPLACE "/*chart*/" "${chart}" page "${page}")
string(REPLACE "/*report*/" "${script}" page "${page}")

# 'sha256-…', in base 64, of what stands between `opening` and `closing`.
function(hash result opening closing)
  string(FIND "${page}" "${opening}" begin)
  string(LENGTH "${opening}" length)
  math(EXPR begin "${begin} + ${length}")
  string(SUBSTRING "${page}" ${begin} -1 text)
  string(FIND "${text}" "${closing}" end)
  string(SUBSTRING "${text}" 0 ${end} text)
  string(SHA256 digits "${text}")
  string(APPEND digits "00") # 264 bits: 44 letters of 6, of which the last stands for nothing
  set(alphabet "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
  set(letters "")
  foreach(at RANGE 0 63 3)
    string(SUBSTRING "${digits}" ${at} 3 three)
    math(EXPR high "0x${three} >> 6")
    math(EXPR low "0x${three} & 63")
    string(SUBSTRING ${alphabet} ${high} 1 first)
    string(SUBSTRING ${alphabet} ${low} 1 second)
    string(APPEND letters ${first} ${second})
  endforeach()
  string(SUBSTRING ${letters} 0 43 letters)
  set(${result} "'sha256-${letters}='" PARENT_SCOPE)
endfunction()
hash(style "<style>" "</style>")
hash(chart "<script>" "</script>")
hash(script "<script type=\"module\">" "</script>")
string(REPLACE "SCRIPTS" "${chart} ${script}" page "${page}")
string(REPLACE "STYLES" "${style}" page "${page}")

file(WRITE ${OUTPUT} "#include \"native/report/report_page.h\"

namespace gnomon {

std::string_view reportPage() {
    return R\"__report__(${page})__report__\";
}

} // namespace gnomon
")
