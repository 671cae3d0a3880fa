# Writes src/sampling/interfaceTag.hpp.in: what a library of function objects and the program that loads it must have in common. A file that says the same
# already is left alone.
#
#   cmake -Dsource=<folder of the project> -Dversion=<number> -Dcompiler=<name and version> -Dmachine=<flags> -Drooms=<folder,folder..> -Dto=<file> -P ..
string(REPLACE "," ";" rooms ${rooms})
list(TRANSFORM rooms REPLACE "(.+)" "${source}/src/\\1/*.hpp" OUTPUT_VARIABLE headers)
file(GLOB headers ${headers})
list(SORT headers)
set(text "")
foreach(header ${headers})
    file(SHA256 ${header} sum)
    string(APPEND text ${sum})
endforeach()
string(SHA256 sum "${text}")
string(SUBSTRING ${sum} 0 12 headers)
configure_file(${source}/src/sampling/interfaceTag.hpp.in ${to} @ONLY)
