# Run by CPack on what it has installed: its own stripping leaves out static libraries, whose symbols for profiling are ten times their code.
find_program(strip strip REQUIRED)
file(GLOB_RECURSE libraries ${CPACK_TEMPORARY_DIRECTORY}/*.a)
foreach(library ${libraries})
    execute_process(COMMAND ${strip} --strip-debug --enable-deterministic-archives ${library} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
