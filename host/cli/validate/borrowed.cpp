// What a call lends (the block, the tables of functions, ids, texts) is another one for each call, and nothing is
// behind those of earlier calls: whoever keeps a pointer is seen at its next use.
#include <isogloss_flow.h>
#include <isogloss_provenance.h>
#include <sys/mman.h>

#include <array>
#include <stdexcept>
#include <string_view>

#include "isogloss/engine/host_functions.hpp"
#include "validate/guarded_texts.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// Places that nothing can read, each of which stands for what one call lends.
class Handles {
 public:
  Handles() : begin_(mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)) {
    if (begin_ == MAP_FAILED) throw std::runtime_error("no memory for handles");
  }
  ~Handles() { munmap(begin_, bytes); }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  template <class T>
  T* next() {
    used_ = (used_ + distance) % bytes;
    return reinterpret_cast<T*>(static_cast<char*>(begin_) + used_);
  }

 private:
  static constexpr std::size_t bytes = 64 << 20, distance = 16;
  void* begin_;
  std::size_t used_ = 0;
};

/// What the call of the plugin that is under way may use; null: no call is.
struct Lender {
  const ig_syntax* syntax = nullptr;
  Handles handles;
  GuardedTexts texts;
  const ig_block* block_handle = nullptr;
  ig_block* block = nullptr;
  const ig_link* link_handle = nullptr;
  ig_link* link = nullptr;
  const ig_link_api* link_api = nullptr;
  std::array<ig_host, 16> hosts{};
  std::array<ig_link_api, 4> apis{};
  std::size_t calls = 0, creations = 0;
  const ig_flow_1* flow = nullptr;
  const ig_provenance_1* provenance = nullptr;
  std::string_view misuse{};
};
thread_local Lender* lender = nullptr;

// Is the argument lent at present, and what does it stand for?
bool is_lent(const ig_block* b) {
  if (b == lender->block_handle && b != nullptr) return true;
  lender->misuse = "it calls a function with the block of an earlier call, which was only lent";
  return false;
}
bool is_lent(ig_block* b) { return is_lent(static_cast<const ig_block*>(b)); }
bool is_lent(ig_link* l) {
  if (l == lender->link_handle && l != nullptr) return true;
  lender->misuse = "it calls a function with the link of an earlier create(), which was only lent";
  return false;
}
template <class T>
bool is_lent(const T&) {
  return true;
}
ig_block* lender_s_own(const ig_block*) { return lender->block; }
ig_block* lender_s_own(ig_block*) { return lender->block; }
ig_link* lender_s_own(ig_link*) { return lender->link; }
template <class T>
T lender_s_own(T argument) {
  return argument;
}

template <class R, class... A>
R lend(R (*function)(A...), A... arguments) {
  if (!(is_lent(arguments) && ...)) return R();
  return function(lender_s_own(arguments)...);
}

template <auto member>
struct LentCall;
template <class R, class... A, R (*ig_host::*member)(A...)>
struct LentCall<member> {
  static R call(A... arguments) { return lend<R, A...>(host_table(Mode::fast).*member, arguments...); }
};
template <class R, class... A, R (*ig_link_api::*member)(A...)>
struct LentCall<member> {
  static R call(A... arguments) { return lend<R, A...>(lender->link_api->*member, arguments...); }
};
template <class R, class... A, R (*ig_flow_1::*member)(A...)>
struct LentCall<member> {
  static R call(A... arguments) { return lend<R, A...>(lender->flow->*member, arguments...); }
};
template <class R, class... A, R (*ig_provenance_1::*member)(A...)>
struct LentCall<member> {
  static R call(A... arguments) { return lend<R, A...>(lender->provenance->*member, arguments...); }
};

/// In a table that was lent to an earlier call.
template <auto member>
struct StaleCall;
template <class R, class S, class... A, R (*S::*member)(A...)>
struct StaleCall<member> {
  static R call(A...) {
    lender->misuse = "it uses the table of functions of an earlier call, which was only lent";
    return R();
  }
};

ig_text lent_text(ig_text text) { return lender->texts.copy(text); }

const void* lent_service(ig_link* link, const char* id) {
  const void* const real = lend(lender->link_api->service, link, id);
  if (real == nullptr) return nullptr;
  if (std::string_view(id) == IG_FLOW_SERVICE) {
    static thread_local ig_flow_1 out;
    out = *(lender->flow = static_cast<const ig_flow_1*>(real));
    out.label = LentCall<&ig_flow_1::label>::call;
    out.go = LentCall<&ig_flow_1::go>::call;
    out.frame = LentCall<&ig_flow_1::frame>::call;
    out.here = LentCall<&ig_flow_1::here>::call;
    out.text = LentCall<&ig_flow_1::text>::call;
    return &out;
  }
  if (std::string_view(id) == IG_PROVENANCE_SERVICE) {
    static thread_local ig_provenance_1 out;
    out = *(lender->provenance = static_cast<const ig_provenance_1*>(real));
    out.answered = LentCall<&ig_provenance_1::answered>::call;
    out.variable = LentCall<&ig_provenance_1::variable>::call;
    return &out;
  }
  return real;
}

template <template <auto> class Call>
ig_link_api api_of(const ig_link_api& real) {
  using A = ig_link_api;
  ig_link_api out = real;
  const auto replace = [&]<auto... members>() { ((out.*members = Call<members>::call), ...); };
  replace.template
  operator()<&A::symbol, &A::option_number, &A::option_integer, &A::option_text, &A::expand, &A::field_path,
             &A::field_unit, &A::service, &A::setting, &A::table, &A::value, &A::set_value, &A::text_value,
             &A::row_count, &A::row_name, &A::fail, &A::idle, &A::set_text_value>();
  return out;
}

template <template <auto> class Call>
const ig_host& host_of() {
  static const ig_host out = [] {
    ig_host all = host_table(Mode::fast);
    all.flags = 0;
    replace_functions<Call>(all);
    return all;
  }();
  return out;
}

/// One call of the plugin. What it lends is gone when it ends.
class Loan {
 public:
  explicit Loan(ig_block* block) : host_(&lender->hosts[lender->calls++ % lender->hosts.size()]) {
    *host_ = host_of<LentCall>();
    lender->block = block;
    lender->block_handle = handle_ = lender->handles.next<ig_block>();
  }
  ~Loan() {
    *host_ = host_of<StaleCall>();
    lender->block_handle = nullptr;
    lender->texts.end_call();
  }
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;
  const ig_host* host() const { return host_; }
  ig_block* block() const { return handle_; }

 private:
  ig_host* host_;
  ig_block* handle_;
};

class CreationLoan {
 public:
  CreationLoan(const ig_link_api& api, ig_link* link) : api_(&lender->apis[lender->creations++ % lender->apis.size()]) {
    lender->link_api = &api;
    lender->link = link;
    lender->link_handle = handle_ = lender->handles.next<ig_link>();
    *api_ = api_of<LentCall>(api);
    api_->service = lent_service;
    api_->option_text = [](ig_link* l, std::uint32_t option) {
      return lent_text(LentCall<&ig_link_api::option_text>::call(l, option));
    };
    api_->setting = [](ig_link* l, const char* name) {
      return lent_text(LentCall<&ig_link_api::setting>::call(l, name));
    };
  }
  ~CreationLoan() {
    *api_ = api_of<StaleCall>(*api_);
    lender->link_handle = nullptr;
    lender->texts.end_call();
  }
  CreationLoan(const CreationLoan&) = delete;
  CreationLoan& operator=(const CreationLoan&) = delete;
  const ig_link_api* api() const { return api_; }
  ig_link* link() const { return handle_; }

 private:
  ig_link_api* api_;
  ig_link* handle_;
};

ig_status lent_create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) {
  const CreationLoan loan(*api, link);
  const ig_text copy =
      lent_text({reinterpret_cast<const char*>(ids), ids == nullptr ? 0 : lender->syntax->field_count * sizeof *ids});
  return lender->syntax->create(loan.api(), loan.link(), reinterpret_cast<const ig_field*>(copy.data), self);
}
ig_status lent_restart(void* self, const ig_host*, ig_block* block) {
  const Loan loan(block);
  return lender->syntax->restart(self, loan.host(), loan.block());
}
ig_status lent_build(void* self, const ig_host*, ig_block* block) {
  const Loan loan(block);
  return lender->syntax->build(self, loan.host(), loan.block());
}
std::size_t lent_scan(void* self, const ig_host*, ig_block* block, const char* text, std::size_t size,
                      std::size_t from) {
  const Loan loan(block);
  return lender->syntax->scan(self, loan.host(), loan.block(), text, size, from);
}

/// The syntax, whose calls are lent what they use.
ig_syntax lent_syntax(const ig_syntax& syntax) {
  ig_syntax out = syntax;
  out.create = lent_create;
  if (syntax.restart != nullptr) out.restart = lent_restart;
  if (syntax.build != nullptr) out.build = lent_build;
  if (syntax.scan != nullptr) out.scan = lent_scan;
  return out;
}

}  // namespace

void check_borrowed(Examination& e) {
  constexpr std::uint64_t random_ones = 10;
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    const std::string id = stand.syntax->id;
    Lender lending;
    lending.syntax = stand.syntax;
    lender = &lending;
    const ig_syntax lent = lent_syntax(*stand.syntax);
    stand.alone.linked->chain[stand.alone.position].syntax = &lent;
    {
      e.attempt(id + "; what an earlier call lent (block, functions, ids, texts) may not be used");
      Bench bench(stand.alone, {});
      bench.start();
      for (const TestBlock& block : many_blocks(stand, e, random_ones)) {
        e.attempt(id + ", " + block.name +
                  "; what an earlier call lent (block, functions, ids, texts) may not be used");
        for (int i = 0; i < 2 && lending.misuse.empty(); ++i) bench.run(block, false);
        if (lending.misuse.empty()) continue;
        e.find(id + ", " + block.name, std::string(lending.misuse));
        break;
      }
    }
    stand.alone.linked->chain[stand.alone.position].syntax = stand.syntax;
    lender = nullptr;
  }
}

}  // namespace isogloss::cli
