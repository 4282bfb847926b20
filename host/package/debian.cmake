# Run by CPack between installing the components into ${CPACK_TEMPORARY_DIRECTORY} and packing them: what Debian's
# policy asks for beyond an installation from source.
set(root ${CPACK_TEMPORARY_DIRECTORY})
set(packages isogloss isogloss-dev isogloss-dialects)
if(CPACK_ISOGLOSS_PYTHON)
  list(APPEND packages python3-isogloss)
endif()

function(compress file)
  execute_process(COMMAND gzip -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(move from to)
  cmake_path(GET to PARENT_PATH folder)
  file(MAKE_DIRECTORY ${folder})
  file(RENAME ${from} ${to})
endfunction()

# Documents: the licence is in copyright, the changelog has a name of its own.
set(documents ${root}/isogloss/usr/share/doc/isogloss)
file(REMOVE ${documents}/LICENSE ${documents}/CHANGELOG.md)
foreach(package IN LISTS packages)
  set(documents ${root}/${package}/usr/share/doc/${package})
  file(MAKE_DIRECTORY ${documents})
  file(COPY_FILE ${CMAKE_CURRENT_LIST_DIR}/copyright ${documents}/copyright)
  file(COPY_FILE ${CPACK_ISOGLOSS_SOURCE}/CHANGELOG.md ${documents}/changelog)
  file(WRITE ${documents}/changelog.Debian
       "isogloss (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
       "  * New version; changelog.gz tells what is new.\n\n"
       " -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${CPACK_ISOGLOSS_TIME}\n")
  compress(${documents}/changelog)
  compress(${documents}/changelog.Debian)
  set(overrides ${root}/${package}/usr/share/lintian/overrides)
  file(WRITE ${overrides}/${package} "# Not made for an upload to Debian's archive.\n"
       "${package}: initial-upload-closes-no-bugs *\n")
endforeach()

file(GLOB pages ${root}/isogloss/usr/share/man/man1/*.1)
foreach(page IN LISTS pages)
  compress(${page})
endforeach()

# The shell looks for what packages install in a folder apart from what administrators install.
move(${root}/isogloss/usr/share/zsh/site-functions/_isogloss ${root}/isogloss/usr/share/zsh/vendor-completions/_isogloss)
file(REMOVE_RECURSE ${root}/isogloss/usr/share/zsh/site-functions)

# One folder deeper, for builds for other architectures.
set(library ${root}/isogloss-dev/usr/lib)
file(READ ${library}/pkgconfig/isogloss.pc text)
string(REPLACE "{pcfiledir}/../.." "{pcfiledir}/../../.." text "${text}")
file(WRITE ${library}/${CPACK_ISOGLOSS_MULTIARCH}/pkgconfig/isogloss.pc "${text}")
file(REMOVE_RECURSE ${library}/pkgconfig)

# Without debug information; an archive keeps its symbols.
file(GLOB programs ${root}/isogloss/usr/bin/* ${root}/isogloss/usr/lib/isogloss/plugins/*.so
     ${root}/python3-isogloss/usr/lib/python3/dist-packages/isogloss/*.so)
set(unneeded --remove-section=.comment --remove-section=.note)
execute_process(COMMAND ${CPACK_ISOGLOSS_STRIP} --strip-unneeded ${unneeded} ${programs} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CPACK_ISOGLOSS_STRIP} --strip-debug ${unneeded} --enable-deterministic-archives
                        ${library}/libisogloss_engine.a COMMAND_ERROR_IS_FATAL ANY)
