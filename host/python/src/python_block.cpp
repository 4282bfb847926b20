// A block as a function in Python sees it: fields by path, each checked against what the syntax declares.
#include <array>
#include <vector>

#include "python_syntax.hpp"

namespace isogloss::python {

namespace {

/// Program text may hold any byte.
py::str text_of(ig_text text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data, static_cast<py::ssize_t>(text.size), "replace"));
}

ig_text view(const std::string& text) { return {text.data(), text.size()}; }

}  // namespace

ig_block* PythonBlock::open() const {
  if (block_ == nullptr) throw std::runtime_error("the block has ended: a syntax keeps values, not the block");
  return block_;
}

const PythonBlock::Field& PythonBlock::field(const std::string& path, std::uint32_t access, const char* verb) const {
  const auto found = names_.fields.find(path);
  if (found == names_.fields.end()) throw py::key_error("the syntax does not declare the field " + path);
  if (access != 0 && (found->second.access & access) == 0)
    throw py::key_error("the syntax does not declare that it " + std::string(verb) + " " + path);
  return found->second;
}

py::object PythonBlock::object(const Field& f, ig_value value) const {
  switch (f.type) {
    case IG_NUMBER: return py::float_(value.number);
    case IG_INTEGER: return py::int_(value.integer);
    case IG_SYMBOL: return text_of(host_->symbol_text(block_, static_cast<ig_symbol>(value.symbol)));
    case IG_BOOLEAN: return py::bool_(value.integer != 0);
    default: return py::bool_(true);  // a code or a switch that is there
  }
}

py::object PythonBlock::get(const std::string& path) const {
  ig_block* const block = open();
  const Field& f = field(path, 0, "");
  if (f.type == IG_TRANSFORM) {
    std::array<double, 16> matrix;
    if (host_->transform(block, f.id, matrix.data()) == 0) return py::none();
    py::tuple out(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i) out[i] = matrix[i];
    return out;
  }
  ig_value value{};
  if (host_->get(block, f.id, &value) == 0) return py::none();
  return f.type == IG_TEXT ? text_of(host_->text(block, f.id)) : object(f, value);
}

ig_value PythonBlock::value(const std::string& path, const Field& f, const py::object& given) {
  ig_value out{};
  switch (f.type) {
    case IG_NUMBER: out.number = given.cast<double>(); break;
    case IG_INTEGER: out.integer = given.cast<std::int64_t>(); break;
    case IG_BOOLEAN: out.integer = given.cast<bool>() ? 1 : 0; break;
    case IG_SYMBOL: out.symbol = host_->symbol(block_, view(given.cast<std::string>())); break;
    case IG_SWITCH: out.integer = 1; break;
    default: throw py::type_error("a syntax in Python cannot write the code " + path);
  }
  return out;
}

void PythonBlock::set(const std::string& path, const py::object& given) {
  ig_block* const block = open();
  const Field& f = field(path, IG_WRITE, "writes");
  if (f.type == IG_TEXT) {
    host_->set_text(block, f.id, view(given.cast<std::string>()));
  } else if (f.type == IG_TRANSFORM) {
    const auto matrix = py::tuple(given);
    if (matrix.size() != 16) throw py::value_error("a transform has 16 numbers, row by row: " + path);
    double numbers[16];
    for (std::size_t i = 0; i < 16; ++i) numbers[i] = matrix[i].cast<double>();
    host_->set_transform(block, f.id, numbers);
  } else {
    host_->set(block, f.id, value(path, f, given));
  }
  has_changed_ = true;
}

void PythonBlock::erase(const std::string& path) {
  ig_block* const block = open();
  host_->erase(block, field(path, IG_WRITE, "writes").id);
  has_changed_ = true;
}

py::object PythonBlock::take(const std::string& path) {
  ig_block* const block = open();
  const Field& f = field(path, IG_TAKE, "takes");
  if (f.type == IG_CODE) {
    std::uint32_t found = 0;
    if (host_->take_code(block, &f.id, 1, &found) < 0) return py::none();
    has_changed_ = true;
    return py::bool_(true);
  }
  ig_value value{};
  if (host_->take(block, f.id, &value) == 0) return py::none();
  has_changed_ = true;
  return object(f, value);
}

bool PythonBlock::is_fresh(const std::string& path) const {
  ig_block* const block = open();
  return host_->is_fresh(block, field(path, 0, "").id) != 0;
}

py::str PythonBlock::text() const { return text_of(host_->source(open())); }

void PythonBlock::report(const std::string& code, const py::args& arguments, const py::object& at) {
  ig_block* const block = open();
  const auto known = names_.diagnostics.find(code);
  if (known == names_.diagnostics.end()) throw py::key_error("the syntax does not declare the diagnostic " + code);
  std::vector<std::string> texts;
  for (const py::handle& argument : arguments) texts.push_back(py::str(argument).cast<std::string>());
  std::vector<ig_argument> all;
  for (const std::string& text : texts) all.push_back({1, 0, 0, view(text)});
  const ig_field where = at.is_none() ? IG_NO_FIELD : field(at.cast<std::string>(), 0, "").id;
  host_->report(block, known->second, where, 0, 0, all.data(), static_cast<std::uint32_t>(all.size()));
}

}  // namespace isogloss::python
