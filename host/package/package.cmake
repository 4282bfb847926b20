# isogloss.pc for builds without CMake, and the packages for Debian: `./dev package`, or `cpack -G DEB` in a build tree.
#
# A component of the installation is a package of the same name. Where Debian's policy wants files in other places than
# an installation from source has them, debian.cmake moves them.
set(folder ${CMAKE_CURRENT_LIST_DIR})
set(ISOGLOSS_PREFIX ../..)
configure_file(${folder}/isogloss.pc.in ${PROJECT_BINARY_DIR}/isogloss.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/isogloss.pc DESTINATION lib/pkgconfig COMPONENT isogloss-dev)

set(CPACK_COMPONENTS_ALL isogloss isogloss-dev isogloss-dialects)
if(ISOGLOSS_HAS_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python3-isogloss)
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME isogloss)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_OUTPUT_FILE_PREFIX ${PROJECT_BINARY_DIR}/packages)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PROJECT_CONFIG_FILE ${folder}/cpack.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${folder}/debian.cmake)
set(CPACK_ISOGLOSS_SOURCE ${PROJECT_SOURCE_DIR})
set(CPACK_ISOGLOSS_DATE ${ISOGLOSS_DATE})
set(CPACK_ISOGLOSS_MULTIARCH ${CMAKE_LIBRARY_ARCHITECTURE})
set(CPACK_ISOGLOSS_PYTHON ${ISOGLOSS_HAS_PYTHON})
set(CPACK_ISOGLOSS_STRIP ${CMAKE_STRIP})
include(CPack)
