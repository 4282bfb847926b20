// The motion stream as values on the thread that runs: no queue, no text.
#include "isogloss/engine/motion.hpp"

#include "export/motion_reader.hpp"
#include "export/motion_teller.hpp"

namespace isogloss {
namespace {

class ListeningExporter : public Exporter {
 public:
  ListeningExporter(MotionListener listener, const MotionListenerOptions& options)
      : teller_(std::move(listener)), reader_(options.zero_moves) {}

  void begin(Document& initial, const SymbolTable& symbols) override {
    teller_.begin();
    reader_.begin(initial, symbols);
  }
  bool block(Document& document, const SymbolTable& symbols) override {
    teller_.block(document.source);
    reader_.read(document, symbols, teller_);
    return teller_.goes_on();
  }
  bool end() override { return teller_.goes_on(); }

 private:
  MotionTeller teller_;
  MotionReader reader_;
};

}  // namespace

std::unique_ptr<Exporter> make_motion_listener(MotionListener listener, const MotionListenerOptions& options) {
  return std::make_unique<ListeningExporter>(std::move(listener), options);
}

}  // namespace isogloss
