// The host's own diagnostics. Codes are never reused; rows stand in order of code.
#include "isogloss/engine/diagnostic.hpp"

namespace isogloss {

const std::vector<DiagnosticInfo>& host_diagnostics() {
  static constexpr auto error = Severity::error;
  static constexpr auto warning = Severity::warning;
  static constexpr auto note = Severity::note;
  static const std::vector<DiagnosticInfo> table{
      // dialect files: 0100-0199
      {error, "IG-0101", "no dialect '{0}' in the folders searched: {1}",
       "A dialect is named by its file without .xml, in one of the dialect folders (--dialects, the environment, the "
       "installation), or by the path of its file. `isogloss list dialects` shows what is there.",
       "isogloss run part.nc -d fanuk"},
      {error, "IG-0102", "cannot read {0}: {1}", "The file is not there, is a folder, or may not be read.",
       R"(<ToolOffsetTable src="no-such-file.xml"/>)"},
      {error, "IG-0103", "malformed XML: {0}", "The file is not well-formed XML 1.0, or holds a document type.",
       "<Dialect name=>"},
      {error, "IG-0104", "the file must be UTF-8, this is {0}",
       "Files are read as UTF-8, with or without a byte order mark, so that columns can be told exactly.",
       R"(<?xml version="1.0" encoding="ISO-8859-1"?>)"},
      {error, "IG-0105", "{0} exceeds the limit of {1}",
       "A file may have 16 MiB, a dialect with all its files 64 MiB and 16 ancestors; elements may be nested 64 deep "
       "and "
       "have 256 attributes; a file's chain may have 4096 elements.",
       "<A><A><A>…"},
      {error, "IG-0106", "the root element must be {0}, not {1}",
       "A dialect file begins with <Dialect xmlns=\"urn:isogloss:dialect:1\" name=\"…\">; no prefixes.",
       R"(<Dialect name="acme">)"},
      {error, "IG-0107", "<{0}> does not belong in <{1}>",
       "`isogloss schema dialect` prints what may stand where, for editors and xmllint.", "<Chian/>"},
      {error, "IG-0108", "<{0}> has no attribute '{1}'",
       "The attributes of the file's own elements are fixed; those of a syntax or dependency are its options.",
       R"(<Segmenter kind="line"/>)"},
      {error, "IG-0109", "<{0}> lacks the attribute '{1}'", "The attribute has no default.", "<Plugin/>"},
      {error, "IG-0110", "{1} of <{0}> must be {2}, not '{3}'", "The attribute's value is not one of those allowed.",
       R"(<Severity code="IG-0212" is="fatal"/>)"},
      {error, "IG-0111", "the dialect extends itself: {0}",
       "Following `extends` must end at a dialect that extends none.", R"(a.xml: extends="b"; b.xml: extends="a")"},
      {error, "IG-0112", "<{0}> finds no {1} '{2}' here",
       "An edit names a syntax or dependency that the dialect inherits (by its alias, where it has one), as it stands "
       "after the edits written before.",
       R"(<Remove syntax="DwelSyntax"/>)"},
      {error, "IG-0113", "the name '{0}' is taken ({1})",
       "Two instances of one syntax or dependency need two names: give one of them as=\"…\".",
       "<DwellSyntax/> <DwellSyntax/>"},
      {error, "IG-0114", "<{0}> stands twice; the first is {1}", "Each section and each stage stands once.",
       "<Logic/> <Logic/>"},
      {error, "IG-0115", "<{0}> must stand before <{1}>",
       "The stages are written in the order in which they run: Parsing, Evaluation, Logic, PostLogic, Inspection.",
       "<Logic/> <Parsing/>"},
      {error, "IG-0116", "<{0}> needs a dialect that {1}",
       "A dialect that extends another edits its chain and dependencies; one that extends none lists its chain by "
       "stages.",
       R"(<Dialect name="root"> … <Remove syntax="DwellSyntax"/>)"},
      {error, "IG-0117", "'{0}' leads out of {1}",
       "A dialect reads files beside itself and below only, named by relative paths; `extends` may also name a file in "
       "the dialect folders.",
       R"(<ToolOffsetTable src="../../tools.xml"/>)"},
      {error, "IG-0118", "the root of {0} is <{1}>, not <{2}>",
       "The file that src names has one element, of the dependency's own name, which holds its rows.",
       R"(<ToolOffsetTable src="offsets.xml"/>)"},
      {error, "IG-0119", "text in <{0}>: '{1}'", "The elements of a dialect file hold elements, never text.",
       "<Chain>DwellSyntax</Chain>"},
      {error, "IG-0120", "<{0}> holds nothing to put in", "To take something out, say <Remove>.",
       R"(<Replace syntax="DwellSyntax"/>)"},
      // links: 0200-0299
      {error, "IG-0201", "no plugin '{0}' in the folders searched",
       "The dialect names a plugin that no plugin folder holds, or that could not be loaded. `isogloss doctor` lists "
       "the folders and says of each file why it was not loaded.",
       R"(<Plugin name="isso"/>)"},
      {error, "IG-0202", "no syntax '{0}' in the dialect's plugins",
       "An element of the chain must be the id of a syntax that one of the dialect's plugins contributes.",
       "<DrilingCycleSyntax/>"},
      {error, "IG-0203", "no dependency '{0}' in the dialect's plugins",
       "An element of <Dependencies> must be the id of a dependency that one of the dialect's plugins contributes.",
       "<IsoCordinateTable/>"},
      {error, "IG-0204", "{0} has no option '{1}'",
       "The attributes of a syntax or dependency are its options; `isogloss inspect` lists them.",
       R"(<BoringCycleSyntax retrakt="feed-to-r"/>)"},
      {error, "IG-0205", "option '{0}' of {1} wants {2}, not '{3}'",
       "The value is not of the option's type, or lies outside its range or choices.",
       R"(<DwellSyntax p-unit="hours"/>)"},
      {error, "IG-0206", "{0} must stand after {1} ({2})",
       "The written order of a chain is the order in which it runs, and this syntax needs what the other one writes. "
       "Nothing is re-sorted; `isogloss lint --suggest` prints an order that satisfies every syntax.",
       "<IncrementalResolveSyntax/> <PositioningModeSyntax/>"},
      {error, "IG-0207", "{0} must stand before {1} ({2})",
       "The written order of a chain is the order in which it runs, and this syntax has to act first. Nothing is "
       "re-sorted; `isogloss lint --suggest` prints an order that satisfies every syntax.",
       "<LinearMotionSyntax/> <CircularMotionSyntax/>"},
      {error, "IG-0208", "{0} needs {1}, and nothing in the chain or the initial state writes it",
       "The syntax declares the field as required. Add the syntax that writes it, or an initial value.",
       "<McXyzSyntax/> alone"},
      {error, "IG-0209", "{0} declares {1} as {2}, {3} declares it as {4}",
       "A field has one type and one life. Two plugins that disagree about it cannot stand in one chain.",
       "Feedrate.FeedrateValue as number and as symbol"},
      {error, "IG-0210", "{0} claims the slot '{1}', which {2} holds already ({3})",
       "Only one syntax of a chain may claim an exclusive slot. Remove one, or say override=\"true\" where both are "
       "meant.",
       "two work offset syntaxes"},
      {error, "IG-0211", "{0} needs the service {1}, and no dependency provides it",
       "Add a dependency that provides the service; `isogloss list dependencies` says which do.",
       "<ToolHeightOffsetSyntax/> without <ToolOffsetTable/>"},
      {note, "IG-0212", "{0} writes {1}, which nothing reads",
       "No syntax of the chain, no exporter and no standard section reads the field. A modal field may be read by its "
       "writer alone, which then remembers it.",
       "Acme.Counter"},
      {error, "IG-0213", "{0} has no option '{1}' without a default, and the dialect gives none",
       "This option has no default, so the dialect must give it.", "<AcmeSyntax/>"},
      {error, "IG-0214", "no field '{0}' in this chain",
       "An initial value, a pattern or a setting names a field that no syntax of the chain and no standard section "
       "declares.",
       R"(<Field path="PlaneSelct.Term" value="…"/>)"},
      {error, "IG-0215", "'{0}' is no {1} for {2}", "The text is not of the field's type.",
       R"(<Field path="SpindleSpeed.SpindleSpeed_rpm" value="fast"/>)"},
      {error, "IG-0216", "the chain has {0} syntaxes; {1} is the most",
       "A chain is limited so that its wake lists "
       "stay short.",
       "a generated dialect"},
      {error, "IG-0217", "{0} has no row of the element '{1}'; its rows are <{2}>",
       "The rows of a dependency's table are elements of one name with a key attribute.",
       R"(<IsoCoordinateTable><Ofset id="…"/></IsoCoordinateTable>)"},
      {error, "IG-0218", "a row of {0} needs the attribute '{1}'", "The attribute names the row.",
       R"(<Offset X="10"/>)"},
      {error, "IG-0219", "{0} has no column '{1}'", "A row's attributes are its key and the table's columns.",
       R"(<Offset id="…" Q="10"/>)"},
      {error, "IG-0220", "'{1}' is no value for column '{0}'{2}",
       "A column's values are numbers within its range, or text where it says so.", R"(<Offset id="…" X="ten"/>)"},
      {error, "IG-0221", "{0} looks ahead but does not stand in the stage PostLogic: move it to <PostLogic>",
       "Only post-logic syntaxes see the window of executed blocks.", "a radius compensation under <Logic>"},
      {error, "IG-0222", "{0} declares the text field {1} as modal",
       "Text lives for one block; modal fields hold "
       "numbers and names.",
       "Acme.Message"},
      {error, "IG-0223", "{0} is inspecting, but does not stand in the stage Inspection: move it to <Inspection>",
       "Leftovers are known only when every other syntax has run.", "UnconsumedCheckSyntax under <Logic>"},
      {error, "IG-0224", "{0} fields are read as they were before the block; a chain keeps {1} at most",
       "A syntax that declares a field as `previous` makes the host keep a copy of it. Leave out syntaxes that the "
       "machine does not need.",
       "a generated dialect"},
      {warning, "IG-0242", "{0} wakes while {1} has a value, and no block begins with one: declare its life as modal",
       "A block begins with the modal fields of the block before it and with its words. A field of another life has no "
       "value then, so the syntax is never called for it.",
       "ig::Field<bool> {\"Acme.IsOn\", ig::wake_while}"},
      {error, "IG-0241", "{0} and {1} both answer {2}, and neither says which of them comes first",
       "Two syntaxes that take one code both act on it: a hole is drilled twice, or gets a rapid too many. Leave one "
       "of "
       "them out of the chain. Where both must stand, their declarations after and before say so, or override=\"true\" "
       "on the second element.",
       "a vendor's drilling cycle for G81 beside DrillingCycleSyntax"},
      {error, "IG-0243", "{0}: '{1}' names no code: write Parsing.Flags.{1}",
       "The paths of codes begin with Parsing.Flags. or Parsing.; another field no scanner fills.", "codes=\"M201\""},
      {warning, "IG-0244", "{0}: the pattern '{2}' of the option {1} matches no field of this chain",
       "Nothing of the option's kind in the chain has such a path, so the pattern is ignored. `isogloss list fields` "
       "prints the paths that exist.",
       R"(lengths="Parsing.G81.?{inch}")"},
      {error, "IG-0240", "{0} acts in this block, though nothing that it declares wakes it: check that in its build()",
       "Found by run --checked --call-all, which calls every syntax in every block: a syntax that depends on not being "
       "called gives another result as soon as another declaration wakes it. This is a fault of the plugin.",
       "a syntax that reads a word without asking whether the block holds it"},
      // libraries and plugins: 0300-0399
      {error, "IG-0301", "{0}: not a shared library ({1})",
       "The file in a plugin folder ends in .so but cannot be read as a shared library of this machine.", "notes.so"},
      {error, "IG-0302", "{0}: no symbol ig_plugin_v1",
       "A plugin exports the function ig_plugin_v1. Build it with isogloss_add_plugin().", "libfoo.so"},
      {error, "IG-0303", "{0}: cannot be loaded ({1})",
       "The dynamic linker refused the library: most often a symbol or a library that it needs is missing.",
       "a plugin linked against a missing library"},
      {error, "IG-0304", "{0}: contract version {1}, this host speaks {2}",
       "The plugin was built for another major version of the contract. Ask its vendor for a build for this one.",
       "an old plugin"},
      {error, "IG-0305", "{0}: bad descriptor: {1}",
       "What ig_plugin_v1() returned breaks the contract, so nothing of the plugin is used.", "a null id"},
      {error, "IG-0306", "{0}: the name '{1}' is taken by {2}",
       "Two plugins of one name lie in the folders; the first one found is used.", "two copies of iso.so"},
      {error, "IG-0307", "{0} contributes {1}, which {2} contributes already",
       "The ids of syntaxes and dependencies are unique over all plugins of a dialect.", "two DrillingCycleSyntax"},
      {error, "IG-0308", "{0} could not be created: {1}", "The syntax or dependency refused to start.",
       "an option that the plugin cannot use"},
      {warning, "IG-0309", "{0} exports {1} symbols besides ig_plugin_v1, {2} for instance",
       "Symbols that leak from one plugin can be taken by another. Build with isogloss_add_plugin().",
       "a plugin built by hand"},
      {warning, "IG-0310", "{0} declares the diagnostic {1}, which {2} declares already",
       "Codes of diagnostics are unique, so that `isogloss explain CODE` and the severities of a dialect mean one of "
       "them. "
       "Each plugin has a prefix of its own.",
       "two plugins with ACM-0001"},
      {error, "IG-0350", "{0} of plugin {1} threw an exception out of {2}(), whose result cannot be trusted: {3}",
       "No exception may leave a function of the contract, which is plain C. The host caught it and goes on where that "
       "is possible. This is a fault of the plugin; the SDK catches what its syntaxes throw.",
       "a plugin built without the SDK that throws in build()"},
      // runs: 0400-0499
      {error, "IG-0401", "{0} failed: {1}",
       "The syntax threw while it worked on this block; its result cannot be trusted. This is a fault of the plugin.",
       "a misbehaving plugin"},
      {error, "IG-0402", "{0} broke the contract: {1}",
       "Found by the checked table: the syntax reached a field that it does not declare, or gave a value that the "
       "contract forbids. This is a fault of the plugin.",
       "a syntax that writes an undeclared field"},
      {error, "IG-0403", "the line is longer than {0} bytes; the rest is not read",
       "A line of a program is limited so that memory stays flat.", "a binary file"},
      {warning, "IG-0404", "columns beyond {0} are not told apart", "Words keep their columns in 16 bits.",
       "a program on one line"},
      {error, "IG-0405", "the block makes more than {0} steps; the rest is left out",
       "A block's list of motions is limited so that no program can fill the memory.", "a peck depth of 0.0001"},
      {error, "IG-0406", "no program {0} in this file", "--program names a program that the file does not hold.",
       "--program O9999"},
      {error, "IG-0407", "stopped after {0} blocks", "The limit given by --max-blocks is reached.", "--max-blocks 10"},
      {note, "IG-0408", "the control would stop here; the run goes on",
       "An alarm of the control ends the program there. The default is to go on with the next block and to say so; "
       "--on-error stop ends the run.",
       "an impossible arc"},
      {error, "IG-0409", "the table of names is full",
       "A run may make a limited number of names; a program that makes more is not a real one.", "generated text"},
      {error, "IG-0410", "no dependency or column '{0}'", "--set names a value that the dialect does not have.",
       "--set IsoCoordinateTable.G54.Q=1"},
      {error, "IG-0411", "'{1}' is no value for {0}", "The value given by --set is not a number within the range.",
       "--set IsoCoordinateTable.G54.X=ten"},
      {error, "IG-0412", "the block holds the byte 0x{0}, which is no text of a program",
       "Control bytes have no meaning in a part program. The file may be binary, or damaged.", "a NUL byte"},
      {error, "IG-0413", "the file is UTF-16 text; a program is plain bytes",
       "The file begins with the mark of UTF-16, in which every second byte is empty. Save it as UTF-8 or ASCII.",
       "a file saved as 'Unicode'"},
      {note, "IG-0414", "the program ended; this line and what follows it are not run",
       "Text after the end of the program belongs to other programs of the file (subprograms, most often), or to "
       "nothing. `--program` picks another program of a file.",
       "M30 before the last line"},
      {error, "IG-0415", "no plugin has the dependency '{0}'",
       "A table file of the user (--machine, --offsets, --tools) names a dependency that neither the dialect has nor "
       "any "
       "plugin of the plugin folders.",
       "--machine FILE with <MachineKinematic>"},
      {error, "IG-0416", "calls are nested more than {0} deep, so this one is not made: {1}",
       "A called program calls another, and so on. More levels than the limit (`--max-depth`) are almost always a "
       "program that calls itself, directly or through others.",
       "a program that calls itself"},
      {error, "IG-0417",
       "stopped after {0} calls and jumps; the last one goes from {1} to {2}: --max-jumps sets another limit",
       "So that no program runs forever, calls, returns and jumps are counted. `--max-jumps` sets another limit.",
       "a call that is repeated millions of times"},
      {error, "IG-0418",
       "stopped in a loop after {0} of its blocks: line {1} goes back to line {2}, {3} times so far; --max-loop-blocks "
       "sets another limit",
       "So that no program runs forever, blocks that run again after a jump back are counted. A main program that "
       "starts over for the next part is such a loop; so is a condition that never comes true. `--max-loop-blocks` "
       "sets another limit.",
       "a jump to the line before it"},
      {warning, "IG-0419", "the called program {0} ends here without a return; the run returns to its caller",
       "The end of the text is reached inside a called program. A control stops there with an alarm.",
       "a subprogram whose last line is missing"},
      {warning, "IG-0420", "{0} holds no program {1}, but others: it is run from its first line",
       "The file was found by its name. What stands in it has another number.", "a file that was copied and renamed"},
      {error, "IG-0421", "the run ends here, since it cannot go back: what was read of {0} could not be kept",
       "Standard input, or a pipe, can be read only once; a temporary file keeps what was read. It could not be "
       "written: the folder for temporary files (TMPDIR) is full or missing.",
       "a jump back in a large program on standard input"},
      {error, "IG-0422", "stopped after {0} calls that were nested too deep; the last one stands in {1}",
       "Each call that is not made lets its caller go on, which calls again: programs that call themselves more than "
       "once would run on for ever.",
       "a program that calls itself twice"},
      {warning, "IG-0423", "there is no block in the file: nothing is run",
       "The file is empty, or holds blank lines alone.", "an export that was cut off at once"},
      {error, "IG-0430", "{0} is too large to compute with: correct the numbers of this block; the run ends here",
       "A value overflowed, or came so near to it that lengths and angles cannot be computed any more. No position "
       "from there on would mean anything, so nothing of the block is written and nothing behind it runs.",
       "two incremental moves by 1e308"},
      {error, "IG-0431", "the file cannot be read beyond this line ({0}): the run ends, and no output file is kept",
       "The disk or the network failed, or the file became shorter while it was read. Half a program is no program: an "
       "older file under the name of the output stays.",
       "a program on a share that was disconnected"},
      {error, "IG-0432", "{0} has no row '{1}': {2}",
       "A row that no program can reach would be passed over in silence: correct its name or leave it out.",
       "<Offset id=\"g54\" …/>: names of rows are written as the page of the dependency writes them"},
      {error, "IG-0433", "{0} has the row '{1}' already, in line {2}",
       "Of two rows of one name in one table only one could count.", "a tool that a list names twice"},
      {warning, "IG-0434", "{0} is given values, and nothing asks for them: {1} answers in its place",
       "Both know the same things, and the first one of the dialect answers. Let the one with the values stand first, "
       "leave "
       "the other one out, or give the values to the one that answers; `isogloss lint` shows who answers for what.",
       "<MachineAxes> with limits behind a parameter table that knows the axes"},
      {warning, "IG-0451", "{0} is called out of {1}, which is named otherwise",
       "No file bears the name of the program, and one of the folders that are searched holds it. Where several do, it "
       "is not called.",
       "M98 P1002, where PART2.NC begins with O1002"},
      {error, "IG-0450",
       "stopped after {0} blocks of repeated calls, in pass {3} of {4} of {1} called at {2}: --max-repeat-blocks sets "
       "another limit",
       "So that no output fills the disk, blocks are counted that run again since a call repeats its program. The "
       "first "
       "pass of each call is not counted.",
       "a subprogram of a thousand blocks that is called a million times"},
      {error, "IG-0452", "stopped after {0} bytes of output: --max-output sets another limit",
       "So that no program fills the disk. What was written up to there is kept.",
       "a million calls of a long subprogram"},
      {error, "IG-0453", "stopped because the run takes more than {0} MiB of memory: --max-memory sets another limit",
       "A run needs a few megabytes, whatever the size of its program. What was written up to there is kept.",
       "a program that defines texts in an endless loop"},
      {error, "IG-0455", "stopped after {0} motions: --max-motions sets another limit",
       "Blocks and the steps of cycles are counted, so that no program keeps a machine busy for days. What was written "
       "up "
       "to there is kept.",
       "a pattern of a million holes, called a thousand times"},
      {error, "IG-0454", "stopped after {0} diagnostics: --max-diagnostics sets another limit",
       "The text is no program of this control, or a loop says the same a million times. What was written up to there "
       "is "
       "kept.",
       "a loop with an unknown code in it"},
      // cases, apply, command line: 0500-0599
      {error, "IG-0501", "malformed page: {0}",
       "A case of a page is a heading, prose, and fences after the lines #Previous:, #Ahead:, #Dependencies:, "
       "#BeforeBuild: and #AfterBuild:; the last two must be there.",
       "#BeforeBuild: without a fence"},
      {error, "IG-0502", "no JSON object: {0}", "A block document is one JSON object.", R"({"Parsing": {"X": 1,}})"},
      {error, "IG-0503", "the syntax could not run: {0}",
       "The document does not fit the fields of the chain, or the syntax refused to start.",
       R"({"Parsing": {"X": true}})"},
      {error, "IG-0504", "no syntax '{0}'", "`isogloss list syntaxes` names those that are there.",
       "isogloss apply DrilingCycleSyntax"},
      {error, "IG-0505", "case '{0}' of {1} does not hold",
       "One build of the syntax must turn BeforeBuild into AfterBuild "
       "exactly.",
       "a page that says other numbers than its syntax"},
      {error, "IG-0510", "cannot be read: {0}", "The file is missing, is a folder, or may not be read.",
       "isogloss run missing.nc"},
      {error, "IG-0511", "cannot be written: {0}",
       "The folder is missing or write-protected, the disk is full, or the file is neither a regular file, a pipe nor "
       "a "
       "character device.",
       "isogloss run part.nc -o /"},
      {error, "IG-0530", "this output would replace {0}, which the run reads: give the output another name",
       "An output file appears under its name when the run is complete. The program, a table or a dialect of the same "
       "run must not be lost to it.",
       "isogloss run part.nc -o part.nc"},
      {error, "IG-0531", "this output and {0} are one file, and one would be lost: give each another name",
       "-o and each --save-table write a file of their own.", "isogloss run part.nc -o x --save-table Table=x"},
      {error, "IG-0512", "no dialect in the folders searched",
       "No dialect was named and none could be guessed, since there are none. `isogloss doctor` lists the folders.",
       "isogloss run part.nc --dialects empty"},
      {error, "IG-0513", "{0}", "The command line asks for something that does not fit together.",
       "isogloss run part.nc --emit blocks --format csv"},
      {note, "IG-0514", "dialect {0} ({1}); -d names another",
       "No dialect was named, so it was guessed from the program's text and extension.", "isogloss run part.nc"},
      {error, "IG-0515", "the run has no block at line {0}",
       "The line is empty, lies behind the end of the file or of the run, or was jumped over: the hint says which.",
       "isogloss explain part.nc:99999"},
      {error, "IG-0516", "no syntax, dependency, dialect, field or diagnostic '{0}'",
       "`isogloss list` names what is there.", "isogloss inspect DrilingCycleSyntax"},
      {warning, "IG-0517", "stopped after {0} errors: --max-errors sets another limit",
       "By default 100000, looked at every 65536 blocks: a text with so many is no program of this control.",
       "isogloss run part.nc --max-errors 1"},
      {note, "IG-0518", "{0} errors in {1} blocks: this may be no part program, or one for another control",
       "At least three of four blocks have an error. `isogloss list dialects` names the dialects, `-d` picks one.",
       "isogloss run README.md"},
  };
  return table;
}

}  // namespace isogloss
