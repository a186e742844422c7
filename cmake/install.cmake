# cmake --install: the command, the library with its headers for find_package(weft), scenes, docs.
include(CMakePackageConfigHelpers)

install(TARGETS weft EXPORT weft-targets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include/weft ${PROJECT_BINARY_DIR}/include/weft
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/weft PATTERN "invalid" EXCLUDE)
if(WEFT_BUILD_APPS)
    install(TARGETS weft_command DESTINATION ${CMAKE_INSTALL_BINDIR})
    file(RELATIVE_PATH weft_lib_from_bin ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
    set_target_properties(weft_command PROPERTIES INSTALL_RPATH "$ORIGIN/${weft_lib_from_bin}")
endif()

set(weft_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/weft)
install(EXPORT weft-targets NAMESPACE weft:: FILE weft-targets.cmake DESTINATION ${weft_cmake_dir})
configure_package_config_file(cmake/weft-config.cmake.in ${PROJECT_BINARY_DIR}/weft-config.cmake
                              INSTALL_DESTINATION ${weft_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/weft-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/weft-config.cmake
              ${PROJECT_BINARY_DIR}/weft-config-version.cmake
        DESTINATION ${weft_cmake_dir})
