# What `cmake --install` and the Debian package hold:
#
#   bin                      the programs
#   lib/sphFoamLike          what they load; the libraries of the rooms below sampling, for programs and function objects of others
#   lib/cmake/sphFoamLike    find_package(sphFoamLike)
#   include/sphFoamLike      the headers of these rooms
#   share/sphFoamLike        tutorials, documents and etc, in the places that they have in the tree, so that links between pages hold: SPH_PROJECT_DIR
#   share/man, share/bash-completion, share/doc/sphfoamlike
get_property(programs GLOBAL PROPERTY SPH_PROGRAMS)
set(share ${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME})

install(TARGETS sphRanks sphVerification LIBRARY DESTINATION ${SPH_LIBRARY_DIR})

# Headers and libraries: the rooms that function objects use.
sph_rooms_below(sampling rooms)
foreach(each ${rooms})
    get_target_property(room ${each} SPH_ROOM)
    install(DIRECTORY src/${room}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME}/${room} FILES_MATCHING PATTERN *.hpp)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/made/sampling/interfaceTag.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME}/sampling)
target_compile_options(base INTERFACE "$<INSTALL_INTERFACE:${SPH_MACHINE_FLAGS}>")
target_compile_features(base INTERFACE $<INSTALL_INTERFACE:cxx_std_20>)
install(TARGETS ${rooms} EXPORT ${PROJECT_NAME} ARCHIVE DESTINATION ${SPH_LIBRARY_DIR})

# A library of function objects has the headers and flags, and finds the functions in the program that loads it.
add_library(functionObjects INTERFACE)
target_include_directories(functionObjects INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME}>)
target_compile_options(functionObjects INTERFACE "$<INSTALL_INTERFACE:${SPH_MACHINE_FLAGS}>")
target_compile_features(functionObjects INTERFACE $<INSTALL_INTERFACE:cxx_std_20>)
target_link_libraries(functionObjects INTERFACE fmt::fmt OpenMP::OpenMP_CXX)
install(TARGETS functionObjects EXPORT ${PROJECT_NAME})

# What has to be built before.
set(files "")
sph_rooms_below(sampling archives COMPILED)
foreach(each ${programs} sphRanks sphVerification sphVoxels ${archives})
    string(APPEND files "        \"$<TARGET_FILE:${each}>\"\n")
endforeach()
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/requireWholeBuild.cmake CONTENT "set(missing \"\")
foreach(file
${files}    )
    if(NOT EXISTS \"\${file}\")
        cmake_path(GET file FILENAME name)
        list(APPEND missing \${name})
    endif()
endforeach()
if(missing)
    list(JOIN missing \" \" names)
    message(FATAL_ERROR \"nothing is installed: \${names} not built. Build everything first: etc/setup\")
endif()
")

include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/${PROJECT_NAME})
install(EXPORT ${PROJECT_NAME} NAMESPACE ${PROJECT_NAME}:: FILE ${PROJECT_NAME}Targets.cmake DESTINATION ${package})
configure_package_config_file(cmake/package/config.cmake.in ${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake INSTALL_DESTINATION ${package}
                              PATH_VARS share)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake ${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake DESTINATION ${package})

# Tutorials, documents, etc.
configure_file(cmake/installTree.cmake.in ${PROJECT_BINARY_DIR}/installTree.cmake @ONLY)
install(SCRIPT ${PROJECT_BINARY_DIR}/installTree.cmake)
list(JOIN programs "\n" names)
file(WRITE ${PROJECT_BINARY_DIR}/programs "${names}\n")
install(FILES ${PROJECT_BINARY_DIR}/programs DESTINATION ${share}/etc)
foreach(program ${programs})
    install(FILES cmake/package/completion DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${program})
endforeach()

# The pages of the programs, from their own -help.
find_program(SPH_HELP2MAN help2man)
find_program(SPH_GZIP gzip)
if(SPH_HELP2MAN AND SPH_GZIP)
    set(pages)
    foreach(program ${programs})
        set(page ${PROJECT_BINARY_DIR}/man/${program}.1)
        add_custom_command(OUTPUT ${page}.gz
            COMMAND ${CMAKE_COMMAND} -Dprogram=$<TARGET_FILE:${program}> "-Dsource=${PROJECT_NAME} ${PROJECT_VERSION}" -Dhelp2man=${SPH_HELP2MAN}
                    -Dgzip=${SPH_GZIP} -Dinclude=${PROJECT_SOURCE_DIR}/cmake/package/man -Dto=${page} -P ${PROJECT_SOURCE_DIR}/cmake/writeManPage.cmake
            DEPENDS ${program} ${PROJECT_SOURCE_DIR}/cmake/package/man ${PROJECT_SOURCE_DIR}/cmake/writeManPage.cmake COMMENT "" VERBATIM)
        list(APPEND pages ${page}.gz)
    endforeach()
    add_custom_target(manPages ALL DEPENDS ${pages})
    install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
else()
    message(STATUS "man pages are left out: no help2man (Debian: help2man)")
endif()

include(cmake/package.cmake)
