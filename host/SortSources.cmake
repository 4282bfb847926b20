# isogloss_sort_sources(<variable> <header>)
#
# Puts the sources that include a costly header before the others, so that as few batches of a unity build as possible
# read it.
function(isogloss_sort_sources variable header)
  set(users)
  set(others)
  foreach(source IN LISTS ${variable})
    file(STRINGS ${source} includes REGEX "^#include .${header}" LIMIT_COUNT 1)
    if(includes)
      list(APPEND users ${source})
    else()
      list(APPEND others ${source})
    endif()
  endforeach()
  set(${variable} ${users} ${others} PARENT_SCOPE)
endfunction()
