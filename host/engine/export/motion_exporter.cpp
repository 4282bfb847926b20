// The motion stream of a run. Text is written by a thread of its own (MotionQueue); records are as quick to fill as to
// queue, so the thread that runs fills them.
#include <limits>
#include <optional>

#include "export/motion_lines.hpp"
#include "export/motion_queue.hpp"
#include "export/motion_reader.hpp"
#include "export/move_time.hpp"
#include "export/record_writer.hpp"
#include "export/totals.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss {

namespace {

template <class Lines>
class MotionExporter : public Exporter {
 public:
  MotionExporter(const MotionOptions& options, Lines lines)
      : options_(options), reader_(options.zero_moves), events_(std::move(lines)) {}

  void begin(Document& initial, const SymbolTable& symbols) override {
    if (!begun_) events_.lines().header(options_);
    begun_ = true;
    events_.forget_file();
    reader_.begin(initial, symbols);
  }
  bool block(Document& document, const SymbolTable& symbols) override {
    events_.block(document.source);
    reader_.read(document, symbols, events_);
    return events_.ok();
  }
  bool end() override { return events_.drain(); }

 private:
  MotionOptions options_;
  MotionReader reader_;
  MotionQueue<Lines> events_;
  bool begun_ = false;
};

/// Binary, with the totals where they are asked for.
class RecordExporter : public Exporter {
 public:
  RecordExporter(Output& output, const MotionOptions& options) : reader_(options.zero_moves), records_(output) {}
  RecordExporter(Output& output, Summary& summary) : reader_(false), records_(output), totals_(summary) {}

  void begin(Document& initial, const SymbolTable& symbols) override {
    if (!begun_) records_.header();
    begun_ = true;
    records_.forget_file();
    reader_.begin(initial, symbols);
    timer_ = MoveTimer(initial.chain == nullptr ? RapidRates{} : rapid_rates(*initial.chain));
    timer_.begin(initial);
    if (totals_) totals_->begin();
  }
  bool block(Document& document, const SymbolTable& symbols) override {
    records_.block(document.source);
    if (totals_) totals_->block();
    document_ = &document;
    reader_.read(document, symbols, *this);
    return records_.ok();
  }
  bool end() override { return records_.flush(); }

  void move(const Move& m) {
    const MoveTime time = timer_.of(m, *document_);
    records_.move(m, time.is_known ? time.seconds : std::numeric_limits<double>::quiet_NaN());
    if (totals_) totals_->move(m, time);
  }
  void dwell(double seconds) {
    records_.dwell(seconds);
    if (totals_) totals_->dwell(seconds);
  }
  void orient(double degrees) {
    records_.orient(degrees);
    if (totals_) totals_->orient(degrees);
  }
  void tool(std::int64_t number) {
    records_.tool(number);
    if (totals_) totals_->tool(number);
  }
  void spindle(std::string_view direction, bool has_speed, double rpm) {
    records_.spindle(direction, has_speed, rpm);
    if (totals_) totals_->spindle(direction, has_speed, rpm);
  }
  void coolant(std::string_view mode) {
    records_.coolant(mode);
    if (totals_) totals_->coolant(mode);
  }
  void stop(std::string_view term) {
    records_.stop(term);
    if (totals_) totals_->stop(term);
  }
  void end(std::string_view term) {
    records_.end(term);
    if (totals_) totals_->end(term);
  }

 private:
  MotionReader reader_;
  RecordWriter records_;
  std::optional<Totals> totals_;
  MoveTimer timer_{RapidRates{}};
  const Document* document_ = nullptr;
  bool begun_ = false;
};

template <class Lines>
std::unique_ptr<Exporter> make(const MotionOptions& options, Lines lines) {
  return std::make_unique<MotionExporter<Lines>>(options, std::move(lines));
}

}  // namespace

std::unique_ptr<Exporter> make_motion_exporter(Output& output, const MotionOptions& options) {
  switch (options.format) {
    case Format::csv:
      return options.exact ? make(options, CsvLines<true>(output)) : make(options, CsvLines<false>(output));
    case Format::binary: return std::make_unique<RecordExporter>(output, options);
    case Format::text: return make(options, TextLines(output, options.exact));
    case Format::jsonl: break;
  }
  return options.exact ? make(options, JsonLines<true>(output)) : make(options, JsonLines<false>(output));
}

std::unique_ptr<Exporter> make_motion_exporter(Output& output, Summary& summary) {
  return std::make_unique<RecordExporter>(output, summary);
}

}  // namespace isogloss
