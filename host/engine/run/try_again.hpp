/// Reading and writing that a signal interrupted.
#pragma once

#include <sys/types.h>

#include <cerrno>

namespace isogloss {

/// The result of `call`, which is repeated after a signal; negative: the reason is in errno.
template <class F>
ssize_t try_again(F&& call) {
  ssize_t n;
  do n = call();
  while (n < 0 && errno == EINTR);
  return n;
}

}  // namespace isogloss
