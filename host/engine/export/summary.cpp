// The totals of a run, where nothing else is made of its motions.
#include <iterator>

#include "export/totals.hpp"
#include "isogloss/engine/runner.hpp"

namespace isogloss {

namespace {

class SummaryExporter : public Exporter {
 public:
  SummaryExporter(Summary& summary, const RapidRates& rates) : reader_(false), totals_(summary), timer_(rates) {}

  void begin(Document& initial, const SymbolTable& symbols) override {
    reader_.begin(initial, symbols);
    timer_.begin(initial);
    totals_.begin();
  }
  bool block(Document& document, const SymbolTable& symbols) override {
    totals_.block();
    document_ = &document;
    reader_.read(document, symbols, *this);
    return true;
  }
  bool end() override { return true; }

  void move(const Move& m) { totals_.move(m, timer_.of(m, *document_)); }
  void dwell(double seconds) { totals_.dwell(seconds); }
  void orient(double degrees) { totals_.orient(degrees); }
  void tool(std::int64_t number) { totals_.tool(number); }
  void spindle(std::string_view direction, bool has_speed, double rpm) { totals_.spindle(direction, has_speed, rpm); }
  void coolant(std::string_view mode) { totals_.coolant(mode); }
  void stop(std::string_view term) { totals_.stop(term); }
  void end(std::string_view term) { totals_.end(term); }

 private:
  MotionReader reader_;
  Totals totals_;
  MoveTimer timer_;
  const Document* document_ = nullptr;
};

}  // namespace

RapidRates rapid_rates(const Chain& chain) {
  RapidRates rates;
  const auto* const axes = static_cast<const ig_machine_axis_1*>(chain.service("isogloss.machine-axis/1"));
  if (axes == nullptr) return rates;
  for (std::size_t i = 0; i < std::size(rates.per_second); ++i)
    if (axes->rapid_rate(axes->self, "XYZABC"[i], &rates.per_second[i]) == 0) rates.per_second[i] = 0;
  return rates;
}

RapidRates rapid_rates(const LinkedDialect& linked, const ChainSettings& settings) {
  DiagnosticList ignored;
  try {
    return rapid_rates(Chain(linked, settings, ignored));
  } catch (const std::runtime_error&) {
    return {};  // the run with these settings cannot begin either, and reports why
  }
}

std::unique_ptr<Exporter> make_summary_exporter(Summary& summary, const RapidRates& rates) {
  return std::make_unique<SummaryExporter>(summary, rates);
}

}  // namespace isogloss
