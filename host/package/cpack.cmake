# What CPack makes of the components, read when it runs: the version and the relations of the packages.

# Between two releases the time of the last commit stands in the version, so that a newer package replaces an older one.
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env TZ=UTC git log -1 "--format=%cd" "--date=format-local:%Y%m%d.%H%M|%a, %d %b %Y %H:%M:%S +0000|%s"
  WORKING_DIRECTORY ${CPACK_ISOGLOSS_SOURCE}
  OUTPUT_VARIABLE commit
  ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
file(READ ${CPACK_ISOGLOSS_SOURCE}/CHANGELOG.md changelog)
if(commit MATCHES "^([0-9.]+)\\|(.*)\\|([0-9]+)$")
  set(stamp ${CMAKE_MATCH_1})
  set(CPACK_ISOGLOSS_TIME "${CMAKE_MATCH_2}")
  # The time of each file in the packages, so that one commit gives the same bytes whenever it is packed.
  if("$ENV{SOURCE_DATE_EPOCH}" STREQUAL "")
    set(ENV{SOURCE_DATE_EPOCH} ${CMAKE_MATCH_3})
  endif()
else()  # no clone
  string(REPLACE "-" "" stamp ${CPACK_ISOGLOSS_DATE})
  string(TIMESTAMP CPACK_ISOGLOSS_TIME "%a, %d %b %Y %H:%M:%S +0000" UTC)
endif()
if(NOT changelog MATCHES "## Unreleased[ \n]+## ")
  string(APPEND CPACK_PACKAGE_VERSION "+git${stamp}")
endif()
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(version "${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
if(NOT CPACK_DEBIAN_COMPRESSION_TYPE)  # The test of the packages asks for one that takes less time.
  set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
endif()
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
if("$ENV{DEBFULLNAME}" STREQUAL "" OR "$ENV{DEBEMAIL}" STREQUAL "")
  set(CPACK_DEBIAN_PACKAGE_MAINTAINER "Isogloss developers <isogloss@packages.example.org>")
endif()

set(CPACK_DEBIAN_ISOGLOSS_PACKAGE_NAME isogloss)
set(CPACK_DEBIAN_ISOGLOSS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_ISOGLOSS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_ISOGLOSS_PACKAGE_DEPENDS "isogloss-dialects (= ${version})")
set(CPACK_DEBIAN_ISOGLOSS_PACKAGE_SUGGESTS "isogloss-dev")
set(CPACK_COMPONENT_ISOGLOSS_DESCRIPTION "resolve, explain and check part programs of CNC machines
Isogloss reads part programs in the dialects of CNC controls (Fanuc, Haas,
Siemens, Heidenhain and others) and resolves them to motions in machine
coordinates, with diagnostics and explanations of every value.

This package contains the command and the plugins.")

set(CPACK_DEBIAN_ISOGLOSS-DIALECTS_PACKAGE_NAME isogloss-dialects)
set(CPACK_DEBIAN_ISOGLOSS-DIALECTS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_ISOGLOSS-DIALECTS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_ISOGLOSS-DIALECTS_PACKAGE_ENHANCES isogloss)
set(CPACK_COMPONENT_ISOGLOSS-DIALECTS_DESCRIPTION "dialects of CNC controls and example machines for isogloss
The XML files that put the syntaxes of the plugins of isogloss in the order of
a control, their default tables, and example machines with their backups.")

set(CPACK_DEBIAN_ISOGLOSS-DEV_PACKAGE_NAME isogloss-dev)
set(CPACK_DEBIAN_ISOGLOSS-DEV_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_ISOGLOSS-DEV_PACKAGE_DEPENDS
    "isogloss (= ${version}), libfmt-dev, libpugixml-dev, nlohmann-json3-dev")
set(CPACK_DEBIAN_ISOGLOSS-DEV_PACKAGE_SUGGESTS "cmake, pkgconf")
set(CPACK_COMPONENT_ISOGLOSS-DEV_DESCRIPTION "write plugins for isogloss, or embed it in a program
The contract between host and plugins in C, what an author of plugins in C++
includes, the library as a static archive, CMake package files, isogloss.pc,
the schemas of dialect files and of the block document, and two examples.")

# The module is compiled for this release's interpreter alone.
execute_process(COMMAND /usr/bin/python3 -c "import sys; v = sys.version_info; print(f'python3 (>= {v[0]}.{v[1]}), python3 (<< {v[0]}.{v[1] + 1})')"
                OUTPUT_VARIABLE python ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
set(CPACK_DEBIAN_PYTHON3-ISOGLOSS_PACKAGE_NAME python3-isogloss)
set(CPACK_DEBIAN_PYTHON3-ISOGLOSS_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON3-ISOGLOSS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON3-ISOGLOSS_PACKAGE_DEPENDS "isogloss (= ${version}), ${python}, python3-numpy")
set(CPACK_COMPONENT_PYTHON3-ISOGLOSS_DESCRIPTION "part programs of CNC machines as Python values
A Python module that runs part programs through isogloss: motions as numpy
arrays, blocks and explanations as dictionaries, diagnostics as objects. A
syntax written in Python can stand in a run.")
