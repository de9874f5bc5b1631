# Headers of C and C++, library, CMake package, pkg-config file, sources of the Fortran module, the manual's and the licences. The tree
# may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(WRC_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/wrc)
install(TARGETS wrc EXPORT wrcTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include_c/wrc DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(DIRECTORY bindings/cpp/wrc DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(EXPORT wrcTargets NAMESPACE wrc:: DESTINATION ${WRC_CMAKE_DIR})
configure_package_config_file(cmake/wrcConfig.cmake.in wrcConfig.cmake INSTALL_DESTINATION ${WRC_CMAKE_DIR})
write_basic_package_version_file(wrcConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/wrcConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/wrcConfigVersion.cmake
        DESTINATION ${WRC_CMAKE_DIR})
file(RELATIVE_PATH WRC_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
list(TRANSFORM WRC_RUN_TIME PREPEND -l OUTPUT_VARIABLE WRC_PC_RUN_TIME)
list(JOIN WRC_PC_RUN_TIME " " WRC_PC_RUN_TIME)
configure_file(cmake/wrc.pc.in wrc.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/wrc.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES data/force_table.bin DESTINATION ${CMAKE_INSTALL_DATADIR}/wrc)
install(DIRECTORY bindings/fortran/ DESTINATION ${CMAKE_INSTALL_DATADIR}/wrc/fortran
        FILES_MATCHING PATTERN "wrc*.f90" PATTERN "*.inc")
install(FILES LICENSE CHANGELOG.md README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY bindings/hosts DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md" PATTERN "pictures/*")
