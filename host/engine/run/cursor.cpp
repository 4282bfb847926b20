#include "run/cursor.hpp"

#include <algorithm>
#include <cstring>

namespace isogloss {

namespace {

constexpr std::size_t window = 64 * 1024;  // more would only touch more pages: reading costs the same

}  // namespace

void Cursor::open(Source& source, std::size_t maximum_line_bytes, const Segmenter& segmenter) {
  source_ = &source;
  segmenter_ = &segmenter;
  joins_ = !segmenter.continuation.empty();
  skips_ = false;
  maximum_ = std::max<std::size_t>(maximum_line_bytes, 1);
  if (buffer_.empty()) buffer_.resize(window);
  begin_ = end_ = whole_ = 0;
  offset_ = unmarked_ = 0;
  terminator_ = '\n';
  started_ = at_end_ = utf16_ = has_failed_ = false;
  number_ = 0;
}

bool Cursor::fill() {
  if (at_end_) return false;
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    whole_ = whole_ > begin_ ? whole_ - begin_ : 0;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) buffer_.resize(buffer_.size() * 2);
  const std::size_t n = source_->read_at(offset_ + end_, buffer_.data() + end_, buffer_.size() - end_);
  end_ += n;
  at_end_ = n == 0;
  if (at_end_) has_failed_ = !source_->failure().empty();
  return n > 0;
}

void Cursor::start() {
  started_ = true;
  while (end_ < 4 && fill()) {
  }
  const auto byte = [&](std::size_t i) { return i < end_ ? static_cast<unsigned char>(buffer_[i]) : 0u; };
  if (byte(0) == 0xef && byte(1) == 0xbb && byte(2) == 0xbf) begin_ = 3;
  offset_ = first_ = begin_;
  utf16_ = (byte(0) == 0xff && byte(1) == 0xfe) || (byte(0) == 0xfe && byte(1) == 0xff);
  // As long as no LF has come, a CR tells nothing before the window is full, however few bytes the source gives at
  // once. The first line may be longer than the window.
  bool has_lf = false, has_cr = false;
  for (std::size_t looked = 0; !has_lf;) {
    const std::string_view fresh(buffer_.data() + begin_ + looked, end_ - begin_ - looked);
    has_lf = fresh.find('\n') != std::string_view::npos;
    has_cr = has_cr || fresh.find('\r') != std::string_view::npos;
    looked += fresh.size();
    const bool is_full = begin_ == 0 && end_ == buffer_.size();
    if (is_full && (has_cr || end_ >= maximum_)) break;
    if (!has_lf && !fill()) break;
  }
  if (!has_lf && has_cr) terminator_ = '\r';
}

void Cursor::seek(std::uint64_t offset, std::uint32_t number) {
  if (!started_) start();
  skips_ = false;
  unmarked_ = 0;
  number_ = number - 1;
  offset = std::max(offset, first_);
  const std::uint64_t first = offset_ - (begin_ - whole_), last = offset_ + (end_ - begin_);
  if (offset >= first && offset <= last) {
    begin_ = whole_ + static_cast<std::size_t>(offset - first);
  } else {
    begin_ = end_ = whole_ = 0;
    at_end_ = has_failed_ = false;
  }
  offset_ = offset;
}

/// From byte `size` of the block on. False where none came: `size` is then all that there is, or more than the limit.
inline bool Cursor::find_end(std::size_t& size) {
  while (true) {  // `size`: bytes known to hold no end
    const char* const from = buffer_.data() + begin_ + size;
    if (const void* const found = std::memchr(from, terminator_, end_ - begin_ - size)) {
      size = static_cast<std::size_t>(static_cast<const char*>(found) - (buffer_.data() + begin_));
      return true;
    }
    size = end_ - begin_;
    if (size > maximum_ || !fill()) return false;
  }
}

bool Cursor::goes_on(std::string_view line) const {
  if (line.find(segmenter_->continuation.back()) == std::string_view::npos) return false;
  const auto ends_in_mark = [&](std::string_view text) {
    const std::size_t last = text.find_last_not_of(" \t\r");
    return last != std::string_view::npos && text.substr(0, last + 1).ends_with(segmenter_->continuation);
  };
  if (ends_in_mark(line)) return true;
  const std::size_t comment = segmenter_->comment.empty() ? std::string_view::npos : line.find(segmenter_->comment);
  return comment != std::string_view::npos && ends_in_mark(line.substr(0, comment));
}

/// True where the line of `size` bytes has no mark of a continuation. Most programs have none or few: the next one is
/// looked for in the whole window.
inline bool Cursor::is_unmarked(std::size_t size) {
  if (offset_ + size <= unmarked_) return true;
  const std::string_view rest(buffer_.data() + begin_, end_ - begin_);
  unmarked_ = offset_ + std::min(rest.find(segmenter_->continuation.back()), rest.size());
  return offset_ + size <= unmarked_;
}

/// More lines for a block whose first line ends at `size`. False when the last one has no end.
bool Cursor::join(Line& line, std::size_t& size) {
  std::size_t begin = 0;
  while (size <= maximum_ && goes_on({buffer_.data() + begin_ + begin, size - begin})) {
    begin = ++size;
    const bool has_end = find_end(size);
    if (!has_end && size == begin) {  // the mark stood in the last line
      --size;
      return true;
    }
    ++line.lines;
    ++number_;
    if (!has_end) return false;
  }
  // For the reader a block that is too long ends here; its remaining lines are not a block either.
  skips_ = size > maximum_ && goes_on({buffer_.data() + begin_ + begin, size - begin});
  return true;
}

/// Line by line, so that a block takes no more memory than the limit.
bool Cursor::skip_rest_of_block() {
  while (skips_) {
    std::size_t size = 0;
    const bool has_end = find_end(size);
    if (size == 0 && !has_end) return false;
    ++number_;
    Line line;
    if (!has_end && size > maximum_) {
      skips_ = false;
      cut_long_line(line, size);
      continue;
    }
    skips_ = goes_on({buffer_.data() + begin_, size});
    const std::size_t used = size + (has_end ? 1 : 0);
    begin_ += used;
    offset_ += used;
    bytes_ += used;
  }
  return true;
}

bool Cursor::next(Line& line) {
  if (!started_) start();
  if (skips_ && !skip_rest_of_block()) return false;
  std::size_t size = 0;
  bool has_end = find_end(size);
  if (size == 0 && !has_end) return false;
  line.number = ++number_;
  line.lines = 1;
  line.offset = offset_;
  if (joins_ && has_end && !is_unmarked(size)) has_end = join(line, size);
  line.truncated = size > maximum_;
  if (line.truncated && !has_end) return cut_long_line(line, size);
  line.text = std::string_view(buffer_.data() + begin_, std::min(size, maximum_));
  const std::size_t used = size + (has_end ? 1 : 0);
  begin_ += used;
  offset_ += used;
  bytes_ += used;
  if (terminator_ == '\n' && line.text.ends_with('\r')) line.text.remove_suffix(1);
  return true;
}

/// Reads and drops the rest of the line; the kept part is moved out of the way.
bool Cursor::cut_long_line(Line& line, std::size_t size) {
  std::vector<char> kept(buffer_.data() + begin_, buffer_.data() + begin_ + maximum_);
  const char* found = nullptr;
  do {
    begin_ = end_;
    offset_ += size;
    bytes_ += size;
    if (!fill()) break;
    found = static_cast<const char*>(std::memchr(buffer_.data() + begin_, terminator_, end_ - begin_));
    size = end_ - begin_;
  } while (found == nullptr);
  if (found != nullptr) {
    const std::size_t behind = static_cast<std::size_t>(found - buffer_.data()) + 1;
    offset_ += behind - begin_;
    begin_ = behind;
  }
  whole_ = begin_;
  if (begin_ < kept.size()) {  // make room in front of what was read on
    buffer_.insert(buffer_.begin(), kept.size(), '\0');
    begin_ += kept.size();
    end_ += kept.size();
    whole_ += kept.size();
  }
  std::copy(kept.begin(), kept.end(), buffer_.begin());
  line.text = std::string_view(buffer_.data(), kept.size());
  return true;
}

LinePlace LinePlace::of(std::string_view text, std::size_t position) { return LinePlaces().at(text, position); }

LinePlace LinePlaces::at(std::string_view text, std::size_t position) {
  if (position < looked_) forget();
  if (end_ == '\0') end_ = text.find('\n') != std::string_view::npos ? '\n' : '\r';
  for (const std::size_t last = std::min(position, text.size()); looked_ < last; ++looked_)
    if (text[looked_] == end_) place_ = {place_.line + 1, looked_ + 1};
  return place_;
}

}  // namespace isogloss
