# Where things go, how another project finds them (find_package(Aeolic)), and the Debian package.
# The library is shared: a project that uses it needs only its headers, and none of the libraries it is built from.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(AEOLIC_DOC_DIR ${CMAKE_INSTALL_DATAROOTDIR}/doc/aeolic)
set(AEOLIC_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Aeolic)
file(RELATIVE_PATH AEOLIC_LIB_FROM_BIN ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_target_properties(aeolic aeolic_bench PROPERTIES INSTALL_RPATH "$ORIGIN/${AEOLIC_LIB_FROM_BIN}")  # The tree can be moved.

install(TARGETS aeolic aeolic_bench RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS aeolic_lib EXPORT AeolicTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/aeolic DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(FILES README.md CHANGELOG.md NOTICE DESTINATION ${AEOLIC_DOC_DIR})
install(FILES LICENSE DESTINATION ${AEOLIC_DOC_DIR} RENAME copyright)
install(DIRECTORY LICENSES/ DESTINATION ${AEOLIC_DOC_DIR}/licenses)  # The licences that NOTICE names.

install(EXPORT AeolicTargets NAMESPACE Aeolic:: DESTINATION ${AEOLIC_CMAKE_DIR})
configure_package_config_file(cmake/AeolicConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/AeolicConfig.cmake
    INSTALL_DESTINATION ${AEOLIC_CMAKE_DIR} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/AeolicConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/AeolicConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/AeolicConfigVersion.cmake
    DESTINATION ${AEOLIC_CMAKE_DIR})

# cpack -G DEB, in the build folder.
set(CPACK_PACKAGE_NAME aeolic)
set(CPACK_PACKAGE_CONTACT "The Aeolic authors <aeolic@example.org>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_DESCRIPTION "Covers a curved surface with a dense streak texture that follows a vector field (line integral
convolution): wall shear stress on a car body, velocity on a slice, any field on an isosurface.
Reads VTK files and writes PNG. Contains the program, another one that measures it, the C++ library and its headers.")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_CURRENT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # Depends on exactly the packages its libraries come from.
if(AEOLIC_GL)
    set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libegl1")  # Looked for when the program runs. Without it the processor draws.
endif()
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
include(CPack)
