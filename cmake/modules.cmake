# One static library per module. Headers are included by their room, `#include "images/Chain.hpp"`, and found only through the targets that a module names in
# DEPENDS, so that including against the direction of DESIGN.md section 2 does not compile: each target shows a folder of the build that holds a link to its room alone.
#
#   sph_module(<name> [DEPENDS <module or library>...] [STENCIL <source>...] [APART <source>...])
#
# STENCIL names the sources that instantiate terms: they are compiled with SPH_STENCIL_FLAGS. APART names those that share a name of their own (an entry, a
# helper) with another source of the room: CMAKE_UNITY_BUILD leaves them by themselves, as it does STENCIL.
function(sph_module name)
    cmake_parse_arguments(PARSE_ARGV 1 module "" "" "DEPENDS;STENCIL;APART")
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR}/src ${CMAKE_CURRENT_SOURCE_DIR})
    set(shown ${PROJECT_BINARY_DIR}/rooms/${name})
    cmake_path(GET room PARENT_PATH floor)
    file(MAKE_DIRECTORY ${shown}/${floor})
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${shown}/${room} SYMBOLIC)
    if(sources)
        add_library(${name} STATIC ${sources})
        target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${shown}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME}>)
        target_link_libraries(${name} PUBLIC ${module_DEPENDS})
    else()
        add_library(${name} INTERFACE)
        target_include_directories(${name} INTERFACE $<BUILD_INTERFACE:${shown}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME}>)
        target_link_libraries(${name} INTERFACE ${module_DEPENDS})
    endif()
    set_target_properties(${name} PROPERTIES SPH_ROOM ${room})
    if(module_STENCIL)
        set_source_files_properties(${module_STENCIL} PROPERTIES COMPILE_OPTIONS "${SPH_STENCIL_FLAGS}")
    endif()
    if(module_APART)
        set_source_files_properties(${module_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
endfunction()

# An application: one folder, one short main, named as its folder.
#
# LOADS_LIBRARIES: the case may name libraries of function objects (sampling/functionLibrary.hpp). What such a library may call, all of the rooms below sampling,
# is linked whole and shown to it: the library itself holds none of it. Static libraries that the program shows, and not shared ones: nothing is compiled as
# position-independent code for it, and the step costs what it costs without.
function(sph_application)
    cmake_parse_arguments(PARSE_ARGV 0 app "LOADS_LIBRARIES" "" "DEPENDS")
    get_filename_component(name ${CMAKE_CURRENT_SOURCE_DIR} NAME)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_executable(${name} ${sources})
    target_link_libraries(${name} PRIVATE ${app_DEPENDS} instructionSet version)
    if(app_LOADS_LIBRARIES)
        sph_rooms_below(sampling rooms COMPILED)
        # The archives stand among the libraries as well, in the order that the linker needs; by then nothing is left to be taken from them.
        list(TRANSFORM rooms REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE archives)
        target_link_options(${name} PRIVATE "LINKER:--whole-archive" ${archives} "LINKER:--no-whole-archive")
        set_target_properties(${name} PROPERTIES ENABLE_EXPORTS ON)
    endif()
    install(TARGETS ${name} RUNTIME)
    set_property(GLOBAL APPEND PROPERTY SPH_PROGRAMS ${name})
endfunction()

# The rooms that a room includes, by whatever way, and itself: sph_rooms_below(<room> <variable> [COMPILED]); COMPILED leaves out those of headers alone.
function(sph_rooms_below room variable)
    set(open ${room})
    set(rooms)
    while(open)
        list(POP_FRONT open next)
        if(NOT TARGET ${next} OR next IN_LIST rooms)
            continue()
        endif()
        get_target_property(folder ${next} SPH_ROOM)
        if(folder)
            list(APPEND rooms ${next})
            get_target_property(links ${next} INTERFACE_LINK_LIBRARIES)
            list(APPEND open ${links})
        endif()
    endwhile()
    if(ARGN STREQUAL COMPILED)
        foreach(each ${rooms})
            get_target_property(type ${each} TYPE)
            if(NOT type STREQUAL STATIC_LIBRARY)
                list(REMOVE_ITEM rooms ${each})
            endif()
        endforeach()
    endif()
    set(${variable} ${rooms} PARENT_SCOPE)
endfunction()

# Of tests, of which as many run at once as there are cores: those that are about threads set their number themselves. Two programs of two threads each wait for
# one another on two cores, and take a hundred times as long.
set(SPH_TEST_ENVIRONMENT OMP_NUM_THREADS=1)

# A test program from all sources of the folder: sph_test(<name> DEPENDS <module>... [APART <source>...] [OPTIMISED <source>...])
#
# APART as of sph_module. The optimiser takes half of the compilation, and what takes time in most tests is in the libraries: it is left to those sources alone
# that OPTIMISED names.
function(sph_test name)
    cmake_parse_arguments(PARSE_ARGV 1 test "" "" "DEPENDS;APART;OPTIMISED")
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_executable(${name} ${sources})
    target_link_libraries(${name} PRIVATE ${test_DEPENDS} GTest::gtest_main)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O0;-g0>)
    if(test_APART)
        set_source_files_properties(${test_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
    if(test_OPTIMISED)
        set_source_files_properties(${test_OPTIMISED} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O2>)
    endif()
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES ENVIRONMENT ${SPH_TEST_ENVIRONMENT})
endfunction()
