#include "diff/motion_stream.hpp"

#include <charconv>

namespace isogloss::cli::parting {

namespace {

/// The next cell of a row; quotes are taken off.
std::string next_cell(std::string_view& row) {
  std::string out;
  if (!row.starts_with('"')) {
    const std::size_t end = std::min(row.find(','), row.size());
    out = row.substr(0, end);
    row.remove_prefix(std::min(end + 1, row.size()));
    return out;
  }
  row.remove_prefix(1);
  while (!row.empty()) {
    const char c = row.front();
    row.remove_prefix(1);
    if (c == '"' && !row.starts_with('"')) break;
    if (c == '"') row.remove_prefix(1);
    out += c;
  }
  if (row.starts_with(',')) row.remove_prefix(1);
  return out;
}

}  // namespace

bool MotionStream::write(std::string_view bytes) {
  rest_.append(bytes);
  std::string_view open = rest_;
  bool goes_on = true;
  for (std::size_t end = 0; goes_on && (end = open.find('\n')) != std::string_view::npos; open.remove_prefix(end + 1)) {
    if (!is_first_row_) goes_on = read_row(open.substr(0, end));
    is_first_row_ = false;
  }
  rest_.erase(0, rest_.size() - open.size());
  return goes_on;
}

bool MotionStream::read_row(std::string_view row) {
  const std::string file = next_cell(row), number = next_cell(row);
  std::uint32_t line = 0;
  std::from_chars(number.data(), number.data() + number.size(), line);
  constexpr std::size_t most = 2000;
  const bool goes_on = block_ != nullptr && block_->line == line && block_->file == file;
  bool is_read = true;
  if (block_ != nullptr && (!goes_on || block_->motions.size() >= most)) {
    is_read = send();
    part_ = goes_on ? part_ + 1 : 0;
  }
  if (block_ == nullptr) {
    block_ = std::make_unique<MotionBlock>();
    block_->file = file;
    block_->line = line;
    const bool is_main = file == program_;
    const std::size_t slash = file.rfind('/');
    block_->key.way =
        is_main ? 1 : std::hash<std::string>{}(slash == std::string::npos ? file : file.substr(slash + 1));
    block_->key.depth = is_main ? 0 : 1;
    block_->key.rank = is_main && order_ != nullptr ? order_->rank(side_, line) : line;
    block_->key.place = part_;
  }
  Motion& motion = block_->motions.emplace_back();
  motion.event = next_cell(row);
  constexpr int plane = 15;  // stands between the columns of numbers
  for (int column = 0, cell = 0; column < Motion::columns; ++cell) {
    const std::string text = next_cell(row);
    if (cell == plane) {
      motion.words = text;
      continue;
    }
    double& value = motion.at[column];
    if (text == "true" || text == "false")
      value = text == "true" ? 1 : 0;
    else if (!text.empty())
      std::from_chars(text.data(), text.data() + text.size(), value);
    if (!text.empty()) motion.known |= 1u << column;
    ++column;
  }
  if (const std::string term = next_cell(row); !term.empty()) motion.words += (motion.words.empty() ? "" : " ") + term;
  return is_read;
}

bool MotionStream::send() { return out_.put(std::move(block_)); }

void MotionStream::finish(std::string fault) {
  if (block_ != nullptr) send();
  auto end = std::make_unique<MotionBlock>();
  end->is_end = true;
  end->fault = std::move(fault);
  out_.put(std::move(end));
}

}  // namespace isogloss::cli::parting
