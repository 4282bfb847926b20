// The module behind the package: thin, typed by the package's stubs. Nothing of the engine runs with the interpreter's
// lock held, except for what a syntax in Python does.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdlib>

#include "block_stream.hpp"
#include "explain/block_json.hpp"
#include "explain/explain_target.hpp"
#include "isogloss/engine/explain.hpp"
#include "motion_arrays.hpp"
#include "request.hpp"

namespace isogloss::python {

namespace {

/// Names of files and words of programs may hold any byte.
py::str text_of(const std::string& text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace"));
}

py::list tuples_of(const std::vector<Diagnostic>& diagnostics) {
  py::list out;
  for (const Diagnostic& d : diagnostics)
    out.append(py::make_tuple(d.code, std::string(to_string(d.severity)), text_of(d.message), text_of(d.where.file),
                              d.where.line, d.where.column, d.end_column, text_of(d.hint)));
  return out;
}

/// An array over the memory of `rows`, which it keeps.
template <class Rows>
py::array bytes_of(Rows&& rows) {
  if (rows.size() == 0) return py::array(py::dtype::of<std::uint8_t>(), 0);
  using Kept = std::remove_cvref_t<Rows>;
  auto kept = std::make_unique<Kept>(std::forward<Rows>(rows));
  auto* const data = kept->data();
  const std::size_t bytes = kept->size() * sizeof *data;
  const py::capsule owner(kept.release(), [](void* p) { delete static_cast<Kept*>(p); });
  return py::array(py::dtype::of<std::uint8_t>(), {bytes}, {std::size_t{1}}, data, owner);
}

py::array motions_of(MotionArrays& arrays) { return bytes_of(std::move(arrays.motions)); }
py::array circles_of(MotionArrays& arrays) { return bytes_of(std::move(arrays.circles)); }

py::list texts_of(const MotionArrays& arrays) {
  py::list out;
  for (const std::string& text : arrays.texts()) out.append(text_of(text));
  return out;
}

py::dict dict_of(const Summary& s) {
  py::dict out;
  out["blocks"] = s.blocks;
  out["events"] = s.events;
  out["rapids"] = s.rapids;
  out["feeds"] = s.feeds;
  out["arcs"] = s.arcs;
  out["tool_changes"] = s.tool_changes;
  out["rapid_length_mm"] = s.rapid_length_mm;
  out["feed_length_mm"] = s.feed_length_mm;
  out["rapid_seconds"] = s.rapid_time_known ? py::object(py::float_(s.rapid_seconds)) : py::none();
  out["feed_seconds"] = s.feed_time_known ? py::object(py::float_(s.feed_seconds)) : py::none();
  out["dwell_seconds"] = s.dwell_seconds;
  py::dict machine, program;
  for (std::size_t i = 0; i < 6; ++i)
    if ((s.axes >> i & 1u) != 0)
      machine[py::str(std::string(1, "XYZABC"[i]))] = py::make_tuple(s.minimum[i], s.maximum[i]);
  for (std::size_t i = 0; s.any_motion && i < 3; ++i)
    program[py::str(std::string(1, "XYZ"[i]))] = py::make_tuple(s.program_minimum[i], s.program_maximum[i]);
  out["machine_extents"] = machine;
  out["program_extents"] = program;
  return out;
}

/// Asks for signals now and then; false once one was to end the run.
bool no_signal_ends(std::optional<py::error_already_set>& interrupted) {
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() == 0) return true;
  interrupted.emplace();
  return false;
}

struct Outcome {
  explicit Outcome(const Request& request) : said(request.maximum_diagnostics), arrays(request.path, said) {}
  BoundedList said;
  MotionArrays arrays;
  Summary summary;
  std::string dialect;
  bool is_started = false;
};

void run_whole(Request& request, PreparedRun& run, Outcome& out, std::optional<py::error_already_set>& interrupted) {
  const std::atomic<bool> never = false;
  Ends ends(run.failure(), never);
  const bool is_one_pass = request.adds_up && !request.zero_moves;  // the totals have no zero moves
  const auto motions = is_one_pass
                           ? make_motion_exporter(out.arrays, out.summary)
                           : make_motion_exporter(out.arrays, {Format::binary, false, request.zero_moves, true, {}});
  std::unique_ptr<Exporter> totals;
  std::vector<Exporter*> exporters{motions.get()};
  if (request.adds_up && !is_one_pass) {
    totals = make_summary_exporter(out.summary, rapid_rates(run.linked(), run.options().chain));
    exporters.push_back(totals.get());
  }
  if (!request.syntaxes.empty()) exporters.push_back(&ends);
  run.options().goes_on = [&] { return !out.said.is_full() && no_signal_ends(interrupted); };
  out.dialect = run.linked().dialect.name;
  try {
    isogloss::run(run.linked(), run.source(), request.path, run.options(), exporters, out.said);
    out.is_started = true;
  } catch (const std::runtime_error&) {  // the diagnostics say which syntax could not be created
    if (out.said.all.empty()) throw;
  }
  if (out.said.is_full())
    out.said.all.push_back(host_diagnostic("IG-0454", {request.path, 0, 0}, {std::to_string(out.said.all.size())}));
}

py::tuple run_program(Request& request) {
  Outcome out(request);
  std::unique_ptr<PreparedRun> run;
  std::optional<py::error_already_set> interrupted;
  {
    const py::gil_scoped_release unlocked;
    run = std::make_unique<PreparedRun>(request, out.said);
    if (run->ready()) run_whole(request, *run, out, interrupted);
  }
  if (interrupted) throw py::error_already_set(*interrupted);
  run->failure().rethrow();
  const py::object summary = request.adds_up ? py::object(dict_of(out.summary)) : py::none();
  return py::make_tuple(out.is_started, tuples_of(out.said.all), out.dialect, motions_of(out.arrays),
                        circles_of(out.arrays), texts_of(out.arrays), summary);
}

/// A stream from a file: motions, circles, texts, diagnostics.
py::tuple read_stream(const std::string& path) {
  DiagnosticList said;
  MotionArrays arrays(path, said);
  {
    const py::gil_scoped_release unlocked;
    std::string error;
    const std::unique_ptr<Source> source = open_file(path, error);
    if (source == nullptr) {
      said.add(host_diagnostic("IG-0510", {path, 0, 0}, {error}));
    } else {
      std::string buffer(std::size_t{1} << 16, '\0');
      bool goes_on = true;
      while (const std::size_t n = goes_on ? source->read(buffer.data(), buffer.size()) : 0)
        goes_on = arrays.write({buffer.data(), n});
      if (goes_on) arrays.end();
    }
  }
  return py::make_tuple(tuples_of(said.all), motions_of(arrays), circles_of(arrays), texts_of(arrays));
}

/// The explained blocks as JSON, and the diagnostics.
py::tuple explain_lines(Request& request, const std::string& numbers, std::uint64_t pass, const std::string& in) {
  BoundedList said(request.maximum_diagnostics);
  std::string json;
  std::unique_ptr<PreparedRun> run;
  {
    const py::gil_scoped_release unlocked;
    run = std::make_unique<PreparedRun>(request, said);
    Workspace places({}, request.home, said);
    const auto lines = cli::read_lines(request.path + ":" + numbers, cli::Lines::needed, places);
    if (run->ready() && lines) {
      ExplainTarget target{lines->first, lines->last, in, pass};
      ExplainReach reach;
      const auto blocks = explain(run->linked(), run->source(), request.path, target, run->options(), said, &reach);
      if (blocks.empty())
        places.report("IG-0515", {in.empty() ? request.path : in, target.line, 0}, {numbers},
                      cli::why_no_block(reach, target, request.path));
      cli::LineTexts texts;
      cli::Json list = cli::Json::array();
      for (const ExplainedBlock& block : blocks) list.push_back(cli::json_of(block, cli::Amount::all, texts));
      if (!blocks.empty()) json = list.dump(-1, ' ', false, cli::Json::error_handler_t::replace);
    }
  }
  run->failure().rethrow();
  return py::make_tuple(text_of(json), tuples_of(said.all));
}

py::list list_dialects(const Request& request) {
  DiagnosticList ignored;
  Workspace workspace(request.folders, request.home, ignored);
  py::list out;
  for (const Dialect& d : workspace.reader().list()) out.append(py::make_tuple(d.name, text_of(d.title)));
  return out;
}

void bind_syntax(py::module_& m) {
  py::class_<SyntaxSpec, std::shared_ptr<SyntaxSpec>>(m, "SyntaxSpec")
      .def(py::init([](std::string name, std::string summary, std::string stage, std::string after, std::string before,
                       const py::list& fields, const py::list& diagnostics, py::object build) {
        auto spec = std::make_shared<SyntaxSpec>();
        spec->name = std::move(name);
        spec->summary = std::move(summary);
        spec->stage = std::move(stage);
        spec->after = std::move(after);
        spec->before = std::move(before);
        for (const py::handle& f : fields) {
          const auto [path, access, type, life] =
              f.cast<std::tuple<std::string, std::uint32_t, std::string, std::string>>();
          spec->fields.push_back({path, access, type, life});
        }
        for (const py::handle& d : diagnostics) {
          const auto [code, severity, text] = d.cast<std::tuple<std::string, std::string, std::string>>();
          spec->diagnostics.push_back({code, severity, text});
        }
        spec->build = std::move(build);
        return spec;
      }));
  m.attr("READ") = static_cast<std::uint32_t>(IG_READ);
  m.attr("WRITE") = static_cast<std::uint32_t>(IG_WRITE);
  m.attr("TAKE") = static_cast<std::uint32_t>(IG_TAKE);
  m.attr("WAKE") = static_cast<std::uint32_t>(IG_WAKE);
  m.attr("WAKE_WHILE") = static_cast<std::uint32_t>(IG_WAKE_WHILE);
  py::class_<PythonBlock, std::shared_ptr<PythonBlock>>(m, "Block")
      .def(
          "get",
          [](const PythonBlock& b, const std::string& path, const py::object& fallback) {
            py::object value = b.get(path);
            return value.is_none() ? fallback : value;
          },
          py::arg("path"), py::arg("default") = py::none())
      .def("__getitem__",
           [](const PythonBlock& b, const std::string& path) {
             py::object value = b.get(path);
             if (value.is_none()) throw py::key_error(path + " has no value in this block");
             return value;
           })
      .def("__contains__", [](const PythonBlock& b, const std::string& path) { return !b.get(path).is_none(); })
      .def("__setitem__", &PythonBlock::set)
      .def("__delitem__", &PythonBlock::erase)
      .def(
          "take",
          [](PythonBlock& b, const std::string& path, const py::object& fallback) {
            py::object value = b.take(path);
            return value.is_none() ? fallback : value;
          },
          py::arg("path"), py::arg("default") = py::none())
      .def("is_fresh", &PythonBlock::is_fresh)
      .def_property_readonly("text", &PythonBlock::text)
      .def(
          "report",
          [](PythonBlock& b, const std::string& code, const py::args& arguments, const py::object& at) {
            b.report(code, arguments, at);
          },
          py::arg("code"), py::kw_only(), py::arg("at") = py::none());
}

void bind_request(py::module_& m) {
  py::class_<Request, std::shared_ptr<Request>>(m, "Request")
      .def(py::init<>())
      .def_readwrite("path", &Request::path)
      .def_readwrite("text", &Request::text)
      .def_readwrite("home", &Request::home)
      .def_readwrite("dialect", &Request::dialect)
      .def_readwrite("machine", &Request::machine)
      .def_readwrite("offsets", &Request::offsets)
      .def_readwrite("tools", &Request::tools)
      .def_readwrite("variables", &Request::variables)
      .def_readwrite("set", &Request::set)
      .def_readwrite("block_skip", &Request::block_skip)
      .def_readwrite("optional_stop", &Request::optional_stop)
      .def_readwrite("start_program", &Request::program)
      .def_readwrite("subprograms", &Request::subprograms)
      .def_readwrite("main_passes", &Request::main_passes)
      .def_readwrite("on_error", &Request::on_error)
      .def_readwrite("max_blocks", &Request::maximum_blocks)
      .def_readwrite("max_motions", &Request::maximum_motions)
      .def_readwrite("max_diagnostics", &Request::maximum_diagnostics)
      .def_readwrite("zero_moves", &Request::zero_moves)
      .def_readwrite("summary", &Request::adds_up)
      .def_readwrite("syntaxes", &Request::syntaxes)
      .def_property(
          "plugins", [](const Request& r) { return r.folders.plugins; },
          [](Request& r, std::vector<std::string> folders) { r.folders.plugins = std::move(folders); })
      .def_property(
          "dialects", [](const Request& r) { return r.folders.dialects; },
          [](Request& r, std::vector<std::string> folders) { r.folders.dialects = std::move(folders); })
      .def_property(
          "machines", [](const Request& r) { return r.folders.machines; },
          [](Request& r, std::vector<std::string> folders) { r.folders.machines = std::move(folders); })
      .def_property(
          "any_plugins", [](const Request& r) { return r.folders.trust == PluginTrust::any; },
          [](Request& r, bool any) { r.folders.trust = any ? PluginTrust::any : PluginTrust::guarded; });
}

}  // namespace

}  // namespace isogloss::python

PYBIND11_MODULE(_isogloss, m) {
  namespace py = pybind11;
  namespace ip = isogloss::python;
  m.doc() = "The engine of Isogloss; use the package isogloss.";
  m.attr("version") = ISOGLOSS_VERSION;
  m.def("is_internal_fault", [](const std::string& code) { return isogloss::is_internal_fault(code); });
  ip::bind_syntax(m);
  ip::bind_request(m);
  m.def("run", &ip::run_program);
  m.def("explain", &ip::explain_lines);
  m.def("read_stream", &ip::read_stream);
  m.def("list_dialects", &ip::list_dialects);
  m.def("stream_header", [] { return py::bytes(isogloss::motion_stream_header()); });
  py::class_<ip::BlockStream>(m, "BlockStream")
      .def(py::init<std::shared_ptr<ip::Request>>())
      .def("next",
           [](ip::BlockStream& stream) -> py::object {
             const std::optional<std::string> piece = stream.next();
             return piece ? py::object(py::bytes(*piece)) : py::none();
           })
      .def("close", &ip::BlockStream::close)
      .def("diagnostics", [](ip::BlockStream& stream) { return ip::tuples_of(stream.diagnostics()); })
      .def("is_started", &ip::BlockStream::is_started);
}
