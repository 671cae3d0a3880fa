# Writes the man page of a program, by help2man from its -help, whose last paragraph begins with what the program is for.
#
#   cmake -Dprogram=<file> -Dsource=<"sphFoamLike 0.1"> -Dhelp2man=<file> -Dgzip=<file> -Dinclude=<file> -Dto=<file without .gz> -P cmake/writeManPage.cmake
execute_process(COMMAND ${program} -help OUTPUT_VARIABLE help OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(FIND "${help}" "\n\n" at REVERSE)
string(SUBSTRING "${help}" ${at} -1 purpose)
string(STRIP "${purpose}" purpose)
string(REPLACE "\n" " " purpose "${purpose}")
string(REGEX REPLACE "\\.( .*)?$" "" purpose "${purpose}")
cmake_path(GET to PARENT_PATH folder)
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${help2man} --no-info --help-option=-help --version-option=-version --section=1 --source=${source} --name=${purpose} --include=${include}
                        --output=${to} ${program} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${gzip} -9nf ${to} COMMAND_ERROR_IS_FATAL ANY)
