# isogloss_add_package(<name> CONTACT "<who> <mail>" SUMMARY <text> [DESCRIPTION <text>] [ARCHITECTURE all])
#
# `cpack --config build/CPackConfig.cmake` makes a package for Debian of what this project installs. It depends on isogloss
# and its dialects, of this version or a later one, and, where it holds a plugin, on the libraries that this needs
# (dpkg-shlibdeps). Its documents are the files copyright and changelog beside the CMakeLists, in the forms of Debian's
# policy; both are installed in share/doc/<name>.

function(isogloss_add_package name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "CONTACT;SUMMARY;DESCRIPTION;ARCHITECTURE" "")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_CONTACT OR NOT arg_SUMMARY)
    message(FATAL_ERROR "isogloss_add_package(${name}): CONTACT and SUMMARY are needed; not known: '${arg_UNPARSED_ARGUMENTS}'")
  endif()
  string(TOLOWER ${name} name)  # as Debian has names
  set(documents share/doc/${name})
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/copyright)
    install(FILES copyright DESTINATION ${documents})
  endif()
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/changelog)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/changelog)
    set(packed ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz)
    find_program(ISOGLOSS_GZIP gzip)
    if(ISOGLOSS_GZIP)  # file(ARCHIVE_CREATE) writes the time into it
      execute_process(COMMAND ${ISOGLOSS_GZIP} -9nc ${CMAKE_CURRENT_SOURCE_DIR}/changelog OUTPUT_FILE ${packed}
                              COMMAND_ERROR_IS_FATAL ANY)
      install(FILES ${packed} DESTINATION ${documents})
    endif()
  endif()

  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_NAME ${name})
  set(CPACK_PACKAGE_CONTACT "${arg_CONTACT}")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${arg_SUMMARY}")
  if(arg_DESCRIPTION)
    set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "${arg_DESCRIPTION}")
  endif()
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
  set(CPACK_DEBIAN_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
      OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  set(CPACK_STRIP_FILES ON)
  if(arg_ARCHITECTURE)  # `all`: files of dialects need no program by themselves
    set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE ${arg_ARCHITECTURE})
    set(CPACK_DEBIAN_PACKAGE_DEPENDS "isogloss-dialects (>= ${isogloss_VERSION})")
  else()
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_PACKAGE_DEPENDS
        "isogloss (>= ${isogloss_VERSION}), isogloss-dialects (>= ${isogloss_VERSION})")
  endif()
  include(CPack)
endfunction()
