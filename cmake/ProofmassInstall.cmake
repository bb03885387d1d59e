# SPDX-License-Identifier: Apache-2.0
include(CMakePackageConfigHelpers)
install(TARGETS proofmass EXPORT proofmassTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET public_headers DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/proofmass)
install(EXPORT proofmassTargets NAMESPACE proofmass::
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/proofmass)
configure_package_config_file(cmake/proofmassConfig.cmake.in proofmassConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/proofmass)
write_basic_package_version_file(proofmassConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/proofmassConfig.cmake
              ${PROJECT_BINARY_DIR}/proofmassConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/proofmass)
