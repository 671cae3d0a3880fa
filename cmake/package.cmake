# The Debian package: cmake --preset package && cmake --build build/package --target package
set(SPH_MAINTAINER "sphFoamLike maintainers <maintainers@sphfoamlike.example>" CACHE STRING "Maintainer field of the Debian package")
string(TOLOWER ${PROJECT_NAME} CPACK_PACKAGE_NAME)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "sphFoamLike")
set(CPACK_PACKAGE_CONTACT ${SPH_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "smoothed particle hydrodynamics in case folders")
set(CPACK_PACKAGE_DESCRIPTION "Solver and utilities for flows with free surfaces, surface tension and contact angles\
 in beds of particles, for suspensions in moulds and for soil.

Cases are folders with constant/ and system/ as OpenFOAM has them; results open in ParaView.")
# With DESTDIR, so that what is installed (scripts of tutorials) knows where it will be.
set(CPACK_SET_DESTDIR ON)
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/prepare.cmake)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${SPH_MAINTAINER})
set(CPACK_DEBIAN_COMPRESSION_TYPE zstd)
# Libraries by dpkg-shlibdeps, in prepare.cmake. By hand: what programs start. reconstructSurface draws through Xvfb, workPrecision and elementTest through gnuplot.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "xvfb, gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "openmpi-bin, bash-completion, python3")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview, g++, cmake, libfmt-dev, libeigen3-dev")
# As dpkg-buildpackage: files that all may read, whatever umask the builder has.
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(documents ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_PACKAGE_NAME})
install(FILES cmake/package/copyright DESTINATION ${documents})
if(SPH_GZIP)
    add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/changelog.gz
        COMMAND ${SPH_GZIP} -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md > ${PROJECT_BINARY_DIR}/changelog.gz DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md COMMENT "")
    add_custom_target(changelog ALL DEPENDS ${PROJECT_BINARY_DIR}/changelog.gz)
    install(FILES ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${documents})
endif()
include(CPack)
