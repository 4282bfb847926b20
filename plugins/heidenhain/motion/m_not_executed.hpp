/// The M functions of Klartext that are known, but not executed.
#pragma once

#include <array>
#include <cstdint>

#include <isogloss/sdk.hpp>

namespace heidenhain {

/// An M function that is recognised and has no effect on the path here.
struct NotExecuted {
  std::uint32_t number;
  ig_severity severity;  // a note: nothing is reported, because nothing changes
  bool has_words;
  const char* effect;
};
inline constexpr std::array not_executed{
    NotExecuted{90, IG_NOTE, false, ""},
    NotExecuted{101, IG_NOTE, true, ""},
    NotExecuted{102, IG_NOTE, false, ""},
    NotExecuted{105, IG_NOTE, false, ""},
    NotExecuted{106, IG_NOTE, false, ""},
    NotExecuted{112, IG_NOTE, true, ""},
    NotExecuted{113, IG_NOTE, false, ""},
    NotExecuted{150, IG_NOTE, false, ""},
    NotExecuted{107, IG_NOTE, false, ""},
    NotExecuted{108, IG_NOTE, false, ""},
    NotExecuted{141, IG_NOTE, false, ""},
    NotExecuted{148, IG_NOTE, false, ""},
    NotExecuted{149, IG_NOTE, false, ""},
    NotExecuted{97, IG_WARNING, false, "it has a meaning with RL and RR only"},
    NotExecuted{98, IG_WARNING, false, "it has a meaning with RL and RR only"},
    NotExecuted{103, IG_WARNING, true, "plunging has the feed in force"},
    NotExecuted{114, IG_ERROR, false, "X Y Z do not follow the rotary axes"},
    NotExecuted{115, IG_NOTE, false, ""},
    NotExecuted{116, IG_WARNING, false, "the feed of rotary axes counts degrees"},
    NotExecuted{117, IG_NOTE, false, ""},
    NotExecuted{118, IG_WARNING, true, "the handwheel moves nothing here"},
    NotExecuted{120, IG_WARNING, true, "it has a meaning with RL and RR only"},
    NotExecuted{124, IG_WARNING, true, "no point of the path is left out"},
    NotExecuted{130, IG_ERROR, false, "the words of the block are positions in the tilted plane"},
    NotExecuted{134, IG_NOTE, false, ""},
    NotExecuted{135, IG_NOTE, false, ""},
    NotExecuted{138, IG_ERROR, true, "all rotary axes take part in tilting"},
    NotExecuted{144, IG_ERROR, false, "positions do not follow the rotary axes"},
    NotExecuted{145, IG_NOTE, false, ""},
};

}  // namespace heidenhain
