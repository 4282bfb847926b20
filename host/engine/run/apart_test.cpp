#include "run/apart.hpp"

#include <catch2/catch.hpp>
#include <thread>

using namespace isogloss;

namespace {

cpu_set_t allowed() {
  cpu_set_t out;
  CPU_ZERO(&out);
  sched_getaffinity(0, sizeof out, &out);
  return out;
}

/// On a thread of its own, since what it may use is changed.
template <class Work>
void on_a_thread(Work work) {
  std::thread(work).join();
}

}  // namespace

TEST_CASE("a thread leaves the processor that it is told, where it has another one") {
  on_a_thread([] {
    const cpu_set_t before = allowed();
    Apart apart;
    for (int round = 0; round < 3; ++round) {
      int here = -1;
      bool may_stay = true;
      // It may be moved between the question and the answer.
      for (int attempt = 0; may_stay && attempt < 100; ++attempt) {
        here = sched_getcpu();
        apart.from(here);
        const cpu_set_t now = allowed();
        may_stay = CPU_ISSET(static_cast<unsigned>(here), &now);
      }
      CHECK(may_stay == (CPU_COUNT(&before) == 1));
      CHECK((sched_getcpu() == here) == may_stay);
    }
  });
}

TEST_CASE("a thread on another processor than the one that it is told stays free") {
  on_a_thread([] {
    const cpu_set_t before = allowed();
    Apart apart;
    apart.from(-1);
    apart.from(CPU_SETSIZE);
    const cpu_set_t now = allowed();
    CHECK(CPU_EQUAL(&before, &now));

    // Somebody has kept it on this one meanwhile, and asks it to leave one that it does not run on.
    const auto here = static_cast<unsigned>(sched_getcpu());
    cpu_set_t kept;
    CPU_ZERO(&kept);
    CPU_SET(here, &kept);
    REQUIRE(sched_setaffinity(0, sizeof kept, &kept) == 0);
    apart.from(here == CPU_SETSIZE - 1 ? 0 : CPU_SETSIZE - 1);
    const cpu_set_t then = allowed();
    CHECK(CPU_EQUAL(&kept, &then));
  });
}
