# Writes applications/version.cpp.in with the version of the project and the commit of the sources, at each build; a file that says the same already is left
# alone, so that nothing is compiled again.
#
#   cmake -Dsource=<folder of the project> -Dversion=<number> -Dto=<file> -P cmake/writeVersion.cmake
find_program(git git)
set(commit "")
if(git AND EXISTS ${source}/.git)
    execute_process(COMMAND ${git} -C ${source} -c safe.directory=* describe --always --dirty --tags OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
configure_file(${source}/applications/version.cpp.in ${to} @ONLY)
