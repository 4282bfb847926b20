// Plugins built without the SDK whose functions let an exception out; which one does is chosen by FAULT_….
#include <isogloss.h>

#include <stdexcept>

namespace {

[[maybe_unused]] void fail(const char* words) { throw std::runtime_error(words); }

const ig_field_decl fields[] = {
    {sizeof(ig_field_decl), IG_READ | IG_WAKE, IG_NUMBER, IG_LIFE_STANDARD, "Parsing.X", "", "", nullptr}};

ig_status create(const ig_link_api*, ig_link*, const ig_field*, void** self) {
  static int anything;
  *self = &anything;
#if defined(FAULT_lets_out_of_create)
  fail("raw create");
#endif
  return IG_CHANGED;
}

void destroy(void*) {
#if defined(FAULT_lets_out_of_destroy)
  fail("raw destroy");
#endif
}

ig_status restart(void*, const ig_host*, ig_block*) {
#if defined(FAULT_lets_out_of_restart)
  fail("raw restart");
#endif
  return IG_UNCHANGED;
}

ig_status build(void*, const ig_host*, ig_block*) {
#if defined(FAULT_lets_out_of_build)
  fail("raw build");
#elif defined(FAULT_lets_a_number_out)
  throw 5;
#elif defined(FAULT_lets_much_out)
  throw std::runtime_error("\x1b[31m" + std::string(100'000'000, 'x'));
#endif
  return IG_UNCHANGED;
}

[[maybe_unused]] std::size_t scan(void*, const ig_host*, ig_block*, const char*, std::size_t, std::size_t position) {
  fail("raw scan");
  return position;
}

ig_syntax make_syntax() {
  ig_syntax s{};
  s.struct_size = sizeof s;
  s.id = "BadSyntax";
  s.summary = "Misbehaves.";
  s.fields = fields;
  s.field_count = 1;
  s.create = create;
  s.destroy = destroy;
  s.restart = restart;
  s.build = build;
#if defined(FAULT_lets_out_of_scan)
  s.scan = scan;
  s.triggers = "G";
#endif
  return s;
}

const ig_syntax syntax = make_syntax();
const ig_syntax* const syntaxes[] = {&syntax};

ig_plugin make_plugin() {
  ig_plugin p{};
  p.struct_size = sizeof p;
  p.abi_major = IG_ABI_MAJOR;
  p.abi_minor = IG_ABI_MINOR;
  p.syntax_count = 1;
  p.name = NAME;
  p.version = "1.0.0";
  p.vendor = "tests";
  p.built_with = "C++";
  p.syntaxes = syntaxes;
  return p;
}

const ig_plugin plugin = make_plugin();

}  // namespace

extern "C" IG_EXPORT const ig_plugin* ig_plugin_v1(void) { return &plugin; }
