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
       "and have 256 attributes; a file's chain may have 4096 elements.",
       "<A><A><A>…"},
      {error, "IG-0106", "the root element must be {0}, not {1}",
       "A dialect file begins with <Dialect xmlns=\"urn:isogloss:dialect:1\" name=\"…\">, a machine's with <Machine>; "
       "no "
       "prefixes.",
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
      {error, "IG-0113", "the name '{0}' is already used ({1})",
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
      {error, "IG-0120", "<{0}> holds no element to insert", "To remove an element, write <Remove>.",
       R"(<Replace syntax="DwellSyntax"/>)"},
      {error, "IG-0121", "an included file includes no other",
       "A machine lists all its files in machine.xml, so that one page shows of what the machine consists.",
       R"(axes.xml, which machine.xml includes: <Machine …> <Include src="tables.xml"/>)"},
      {error, "IG-0122", "{0} does not exist",
       "<Programs> names a folder, or a file of several programs, in which called programs are looked for. The path is "
       "relative to the file that names it.",
       R"(<Programs src="cycels"/>)"},
      {error, "IG-0123", "no machine '{0}' in the folders searched: {1}",
       "A machine is named by its folder, which holds machine.xml, in one of the machine folders (--machines, "
       "ISOGLOSS_MACHINES, the user's configuration folder, beside the dialects), or by the path of the folder or "
       "file. "
       "`isogloss list machines` shows what is there.",
       "isogloss run part.h -m dmu58"},
      {error, "IG-0124", "no importer recognises {0}",
       "An importer recognises a file by its content, and sometimes by its name. `isogloss list importers` shows the "
       "formats; format=\"…\" names one. A file that the machine does not need is named by no <Backup>.",
       R"(<ToolOffsetTable src="notes.txt"/>)"},
      {note, "IG-0125", "{0} is not read: {1} (count: {2})",
       "The importer names what it does not use of a file, so that nothing is lost in silence. The place is the first "
       "one.",
       "TOOL.T with the column LAST_USE"},
      {error, "IG-0126", "{0} cannot be imported: {1}",
       "The file that <Backup> or src names cannot be read, is too large, or is no text.",
       R"(<Backup src="backup/tool.t"/>, and the file is a folder without files)"},
      {error, "IG-0127", "{0}: the importer {1} failed: {2}",
       "The importer broke the contract, or threw. It is a fault of its plugin; the file gives nothing.",
       "an importer that gives a value which is not finite"},
      {warning, "IG-0128", "{0} also holds rows for {1}, which have no effect here",
       "src of an element takes the rows of that element's dependency alone. <Backup src=\"…\"/> takes them all.",
       R"(<ToolOffsetTable src="archive.ini"/>, and the archive holds frames, too)"},
      {error, "IG-0129", "no importer is called {0}",
       "format=\"…\" names an importer. `isogloss list importers` shows them.",
       R"(<Backup src="tool.t" format="HeidenhainTools"/>)"},
      {warning, "IG-0130", "{0} may be of two formats, {1} or {2}: it is read as {1}",
       "Two importers are equally sure of the file. format=\"…\" decides.", R"(<Backup src="offsets.txt"/>)"},
      {note, "IG-0132", "{0} is not read: no importer recognises it (files of this extension: {1})",
       "A folder named by <Backup> may hold files that tell nothing of the machine, such as programs and pictures. "
       "Where "
       "the file matters, name it and its format.",
       R"(<Backup src="backup"/>, and backup/readme.txt)"},
      {note, "IG-0133", "{0} has no place in the file: {1} (count: {2})",
       "The control's format has no column for it, so the file that is written lacks it.",
       "isogloss export of a table with a column that TOOL.T does not have"},
      {note, "IG-0134", "{0} gives nothing: {1} finds no row in it",
       "The file is of a format that is read, and holds no row of a table: it may be cut, or a table that is empty on "
       "the "
       "control.",
       "a TOOL.T that ends after its heading"},
      {note, "IG-0135", "{0} is called from {1}, which hides {2} later in the search order (hidden files: {3})",
       "Several folders of the control's search order hold a file of that name. The first one is called, as on the "
       "control.",
       "CYCLE_A, which stands in CUS.DIR and in CMA.DIR"},
      {error, "IG-0131", "{0} writes no files: the format is only read",
       "`isogloss list importers` shows which formats can be written.",
       "isogloss export -m dmu58 --format SinumerikArchive"},
      {error, "IG-0140", "neither {0} nor the importer {1}, which reads its src, has an option '{2}'",
       "Beside src stand the options of the table and those of the importer that reads the file. `isogloss inspect` "
       "lists both; where both have an option of one name, it is that of the table.",
       R"(<ToolOffsetTable src="TOOL.T" units="inch"/>)"},
      {note, "IG-0141", "{0} is not read: {1}",
       "An importer knows the file, which is no text. In a folder named by <Backup> it hinders nothing.",
       "<Backup src=\"backup\"/>, and an encrypted cycle in it"},
      {warning, "IG-0142", "{0} is not read: its name is usual for {1}, but its text is of none of the known formats",
       "A file of a <Backup> folder is read by the importer that recognises its text. One that is empty, cut or "
       "damaged "
       "in more than a quarter of its lines is not recognised, and all that it holds is missing from the machine. Get "
       "the file anew from the control, or name it with its format: <Backup src=\"backup/tool.t\" format=\"…\"/>.",
       "<Backup src=\"backup\"/>, and backup/TOOL.T holds a letter of the maker"},
      {warning, "IG-0143",
       "row '{0}' has {1}={2} here and {1}={4} in line {3} of the file: the later value is taken (such values: {5})",
       "A file of a control gives each value once. One that gives a value twice was put together from several files, "
       "or "
       "edited by hand: look which of the two is right.",
       "G10L2P1X0.Z-50.Z-60. in a file of work offsets that is read with two values for Z of G54"},
      {error, "IG-0145", "the row '{1}' of {0} sets {2}, a field that this dialect does not have",
       "Fields are written as `isogloss list fields -d DIALECT` and the block stream show them.",
       R"(<Code name="AIR" does="set" fields="Cooling.Mode=FLOOD"/>)"},
      {error, "IG-0146", "the row '{1}' of {0} sets {2} to '{3}', which is not of its type ({4})",
       "A number is decimal, or {P} for the one that the program writes behind P; an integer is whole; a boolean is "
       "true or false; a name has neither blanks nor braces.",
       R"(<Code name="AIR" does="set" fields="Dwell.Time=long"/>)"},
      {error, "IG-0147", "the row '{1}' of {0} cannot set {2}: no syntax that asks this table may write it",
       "Rows set only fields whose value alone is the state. Positions, frames and lengths follow from others, so "
       "codes or a program have to change them.",
       R"(<Code name="AIR" does="set" fields="ProgramXyz.X=5"/>)"},
      {error, "IG-0148", "the row '{1}' of {0} gives {2} in {3}, but the field has another unit: {4}",
       "Values are not converted. Write the value in the unit of the field, or leave the unit out.",
       R"(<Code name="AIR" does="set" fields="Dwell.Time=500 ms"/>)"},
      {warning, "IG-0149", "the row '{1}' of {0} sets {2}, which no syntax of this dialect reads and no output shows",
       "The field belongs to a plugin whose reader is not in this chain, so the row has no effect.",
       R"(<Code name="AIR" does="set" fields="Vendor.Mode=2"/>)"},
      {error, "IG-0150", "'{0}' cannot be the name of {1}: use letters, digits and hyphens, beginning with a letter",
       "Names of files, types and targets follow from it. Words that C++ or CMake reserve, such as class and test, "
       "would not build.",
       "isogloss new plugin 3axis"},
      {error, "IG-0151", "'{0}' exists already ({1}): nothing is written, so choose another name",
       "`isogloss new` never writes into a folder that is there, and two plugins or dialects of one name would hide "
       "each other.",
       "isogloss new plugin acme, twice"},
      {error, "IG-0152", "the prefix '{0}' of the diagnostics {1}: give another one with --prefix",
       "A code of a diagnostic tells by its prefix which plugin it comes from. Without --prefix, the first letters of "
       "the plugin's name are taken.",
       "isogloss new plugin fanta --prefix FAN"},
      {error, "IG-0153", "{0} already has a meaning in dialect {1}: {2} reads it, so choose another one",
       "The syntax that stands first in the chain would take it, and the other one would never see it. `isogloss list "
       "codes -d DIALECT` shows what is in use.",
       "isogloss new plugin acme --cycle G81"},
      {error, "IG-0154", "there is no template for {0}: {1}",
       "`isogloss new plugin` begins with a switch of two M codes for every dialect, with a word or a table for those "
       "whose blocks are rows of addresses, and with a canned cycle in C++ for those that read programs of ISO 6983.",
       "isogloss new plugin acme --cycle G181 --language c"},
      {error, "IG-0155", "no check '{0}' of plugins: isogloss validate --list shows all of them",
       "--only takes the names that `isogloss validate --list` shows in its first column.",
       "isogloss validate acme.so --only random-block"},
      {warning, "IG-0165", "{0} is never called: nothing in this chain writes {1}",
       "A syntax is called when a field, a word or a code that it waits for is set. No scanner, no other syntax that "
       "can be called and no initial value sets one of these. Add what writes them, or remove the syntax. Found by "
       "`isogloss lint`.",
       "<TapeBoundarySyntax/> removed, and a syntax that waits for its field left"},
      {note, "IG-0166", "the option {0} of {1} repeats the default, '{2}': it can be left out",
       "The syntax or dependency has this value without the option. `isogloss inspect` lists the defaults. Found by "
       "`isogloss lint`.",
       R"(<DwellSyntax p-unit="ms"/>)"},
      {note, "IG-0167", "<Configure> sets {0} of {1} to '{2}', which {3} has set already",
       "The inherited chain gives the option this value, so the edit changes nothing. Found by `isogloss lint`.",
       R"(<Configure syntax="FlagSyntax" expressions="leave"/> where the extended dialect has it)"},
      {warning, "IG-0168", "{0} has no effect: <{1}> at {2} takes it back",
       "Edits are applied in written order, and a later one of the same dialect removes or replaces the element, or "
       "sets the option again. Remove the first edit. Found by `isogloss lint`.",
       R"(<Configure syntax="DwellSyntax" p-unit="s"/> <Remove syntax="DwellSyntax"/>)"},
      {warning, "IG-0169", "<{0}> of {1} changes nothing: give it an option, or remove it",
       "Configure sets the options that stand as its attributes, and this one has none. Found by `isogloss lint`.",
       R"(<Configure syntax="DwellSyntax"/>)"},
      {note, "IG-0170", "{0} repeats what {1} says: it can be left out",
       "The dialect inherits the same plugin, or the same initial value. Found by `isogloss lint`.",
       R"(<Plugin name="iso"/> in a dialect that extends iso)"},
      {note, "IG-0171", "override=\"true\" of {0} has no effect: no other syntax claims its slot or its codes",
       "override lets a syntax claim a slot, or take a code, that another syntax of the chain has. Where none has it, "
       "the attribute hides a collision that comes later. Found by `isogloss lint`.",
       R"(<DwellSyntax override="true"/>)"},
      {note, "IG-0177", "{0} declares that it stands {1} {2}, a syntax that no installed plugin has",
       "A neighbour that is not there constrains no order, so a misspelt name in after() or before() has no effect. It "
       "may belong to a plugin that is not installed. A warning where a name is near. Found by `isogloss lint`.",
       R"(.after("ProgramXyzSyntx"))"},
      {note, "IG-0178", "{0} reads {1}, which no installed plugin writes",
       "The field never has a value, so the syntax acts as if it were not there. It may come from a plugin that is not "
       "installed. A warning where a name is near. Found by `isogloss lint`.",
       R"(ig::In<double> feed{"Feedrate.FeedrateValu"};)"},
      {warning, "IG-0179",
       "the option {0} of {1} has a capital letter: options of all other syntaxes are written small",
       "Names of options are compared letter by letter, so who writes it as all others are written hears that there is "
       "no such option. Found by `isogloss lint`.",
       R"(ig::NumberOption clearance{"Clearance", "0.5", "mm", "…"};)"},
      {error, "IG-0172", "no syntax '{0}' in the chain of {1}",
       "`isogloss dialect --why` names a syntax of the chain, by its id or by the name that as=\"…\" gives it. The "
       "plugins may have it: the dialect does not use it.",
       "isogloss dialect iso --why DrilingCycleSyntax"},
      {error, "IG-0173", "no syntax of {0} answers '{1}'",
       "`isogloss inspect CODE -d DIALECT` shows who takes a code or a word in that dialect. `isogloss list codes -d "
       "DIALECT` lists all of them.",
       "isogloss inspect G999 -d iso"},
      {error, "IG-0174", "the page of {0} has no section '{1}'",
       "`isogloss inspect NAME --section TITLE` prints one section of a page, by its heading.",
       "isogloss inspect DwellSyntax --section Diagnostic"},
      {error, "IG-0175", "the folder is not empty, and `isogloss docs` did not make it: name another folder",
       "`isogloss docs` replaces its own pages and writes into no folder that holds something else. A folder that it "
       "made holds the list .isogloss-docs.",
       "isogloss docs -o ."},
      {warning, "IG-0176", "the page of {0} links to '{1}', which the reference does not hold: it is shown as text",
       "A page links to pages of other syntaxes, tables and importers by the names of their files, and to addresses "
       "that "
       "begin with https:// or http://. Of an image, only the text is shown.",
       "[the manual](../manual.md) on the page of a syntax"},
      {error, "IG-0180", "dialect {0} has no field or section '{1}' to follow",
       "`isogloss explain PROGRAM --field` follows values of the block document that outlive the words: Feedrate, "
       "ProgramXyz.X. `isogloss list fields` names them.",
       "isogloss explain part.nc --field Feedrte"},
      {error, "IG-0181", "the range of lines begins at {0} and ends before it, at {1}",
       "A range names its first line and its last one: part.nc:10-20.", "isogloss explain part.nc:20-10"},
      {warning, "IG-0182", "the range has more blocks: only the first {0} are explained",
       "Each explained block costs time and a page of text. Name a shorter range, or follow one value with --field.",
       "isogloss explain part.nc:1-1000000 --brief"},
      {note, "IG-0183", "no block gives {0} a value in these lines",
       "The dialect has the field, and the program was run, but no block of the lines has changed it.",
       "isogloss explain part.nc --field Scaling"},
      {error, "IG-0185", "diff needs two sides: -a and -b, --set-b, --machine-b, --against, or two programs",
       "`isogloss diff` compares two dialects, two machines or two settings with the same programs, or two programs. "
       "Here both sides would be the same.",
       "isogloss diff -d iso part.nc"},
      {error, "IG-0186", "--tolerance needs MM or MM,DEG from 0 to 1000, not '{0}'",
       "With --motions, positions that are not farther apart than this are the same: lengths in mm, angles in degrees. "
       "One number holds for both.",
       "isogloss diff --motions --tolerance -1 old.nc new.nc"},
      {note, "IG-0187", "both sides report the same {0} errors: what follows them may be wrong on both",
       "`isogloss diff` shows what only one side reports. Errors that both sides report alike are no difference, but "
       "the values behind them cannot be trusted on either side.",
       "isogloss diff -a iso -b mine.xml broken.nc"},
      {error, "IG-0188", "{0} cannot run the program: {1}",
       "One side of a comparison did not start or did not come to its end, so there is nothing to compare. Other "
       "diagnostics say what is wrong.",
       "isogloss diff -d iso --set-b ToolOffsetTable.1.H=long part.nc"},
      {warning, "IG-0189", "--ignore {0} has no effect: neither dialect has such a field or section",
       "Fields are named by their path in the block document, as `isogloss list fields` prints them; a section "
       "stands for all of its fields.",
       "isogloss diff -a iso -b mine.xml --ignore Coment part.nc"},
      {warning, "IG-0190", "this feed move has no feed rate: its canonical block has no F",
       "No F is in force in the program. A control that reads the canonical program keeps the F of an earlier block, "
       "or stops. Program F before the move.",
       "G01 X10., before any F"},
      {warning, "IG-0191", "the frame has changed under the tool: a rapid of {0} mm is written to the new coordinates",
       "With --frame program each position counts from the origin of its own block. Where an offset or a plane "
       "changes, the same place of the tool has new coordinates, so the canonical program moves there. --frame machine "
       "has no such jumps.",
       "isogloss run part.nc --emit canonical --frame program, and the part changes from G54 to G55"},
      {warning, "IG-0192", "the centre or the start of this arc is not known: a straight line is written in its place",
       "A canonical arc needs X, Y and Z of its start, its end and its centre.",
       "an arc before the machine has a position in X, Y and Z"},
      {warning, "IG-0193", "the canonical program has no word for {0}: it is left out",
       "The table ProgramText of the dialect in which the program is written (iso) has no row of that name. Give one "
       "by --machine: <ProgramText><Block name=\"coolant THROUGH\" text=\"[N{LINE} ]M88\"/></ProgramText>.",
       "coolant through the spindle, which no ISO code selects alike on all controls"},
      {error, "IG-0194", "the dialect {0} does not say how {1} are written: its ProgramText has no rows for them",
       "The words of a program are rows of the table ProgramText of the dialect. Where it has none, nothing can be "
       "written.",
       "isogloss state part.h:10 --as-preamble"},
      {error, "IG-0195", "no preamble can restore the state before line {0}: {1}",
       "A preamble restores values that a block can set. It cannot enter a called program, a pass of a loop, or a "
       "compensated contour. Choose a line before it, such as the one that changes the tool; --nearest finds one.",
       "isogloss state part.nc:40 --as-preamble, and line 40 is between G41 and G40"},
      {error, "IG-0196", "after the preamble {0} is {1}, but before that line it is {2}: the state is not restored",
       "The preamble was run and compared with the program. The dialect has no row in ProgramText that writes this "
       "state, or the control has no block for it. Choose a line before it was set.",
       "a restart while scaling (G51) is active"},
      {error, "IG-0197", "behind the preamble of line {0} this block moves differently than in the whole program: {1}",
       "The preamble and the rest were run and compared with the whole. Something that no block restores makes the "
       "difference: a loop, a variable, a modal call, a jump to a line before. Choose an earlier line.",
       "a restart inside of WHILE … END"},
      {note, "IG-0198", "rows of {0} were changed before line {1}: the control must still have these values",
       "A preamble does not write offsets and tables again. The control keeps them until a program changes them.",
       "a program that sets its work offsets by G10"},
      {warning, "IG-0199", "after the preamble {0} is {1}, before that line it is {2}; the motions are the same",
       "The dialect has no row in ProgramText that writes this state. The rest of the program moves as in the whole, "
       "but the machine may do it in another way, for example without smoothing.",
       "a restart while G05.1 Q1 is active"},
      {error, "IG-0621", "the preamble of line {0} would cut by itself in its block {1}: it is not written",
       "A preamble may only approach: by rapid, and from the clear level down to the point by feed. A row of "
       "ProgramText "
       "writes a block that drills or moves in another way by feed.",
       "a row that selects a cycle by G81 X.. Z.. R.. where the control drills at once"},
      {note, "IG-0622",
       "the preamble does not move {0}, since no block before line {1} gives a position: move there by hand if needed",
       "A preamble only goes to positions that the program has given. Where an axis stands that no block has moved is "
       "not known; a position computed from assumed offsets could be a collision. The tool axis is retracted first.",
       "isogloss state part.nc:5 --as-preamble, and line 5 is the first that moves X and Y"},
      {note, "IG-0620",
       "no blocks restore the state before line {0}: the restart begins at line {1}, the nearest that can",
       "--nearest tries the lines before the one that was asked for: the call of a subprogram, the approach to a "
       "contour, the first block of a loop. The rest begins there.",
       "isogloss state part.nc:40 --as-preamble --nearest"},
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
      {error, "IG-0205", "option '{0}' of {1} must be {2}, not '{3}'",
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
       "Only one syntax of a chain may claim an exclusive slot. Remove one, or write override=\"true\" where both are "
       "meant.",
       "two work offset syntaxes"},
      {error, "IG-0211", "{0} needs the service {1}, and no dependency provides it",
       "Add a dependency that provides the service; `isogloss list dependencies` says which do.",
       "<ToolHeightOffsetSyntax/> without <ToolOffsetTable/>"},
      {note, "IG-0212", "{0} writes {1}, which nothing reads",
       "No syntax of the chain, no exporter and no standard section reads the field. A modal field that only its "
       "writer reads is not reported: the writer remembers a value in it.",
       "Acme.Counter"},
      {error, "IG-0213", "option '{1}' of {0} has no default, and the dialect gives no value",
       "The dialect must give every option that has no default.", "<AcmeSyntax/>"},
      {error, "IG-0214", "no field '{0}' in this chain",
       "An initial value, a pattern or a setting names a field that no syntax of the chain and no standard section "
       "declares.",
       R"(<Field path="PlaneSelct.Term" value="…"/>)"},
      {error, "IG-0215", "'{0}' is not a valid {1} for {2}", "The text is not of the field's type.",
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
      {error, "IG-0220", "'{1}' is not a valid value for column '{0}'{2}",
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
      {warning, "IG-0235", "no diagnostic has the code '{0}', so its severity changes nothing",
       "A severity belongs to a diagnostic of the host or of a plugin that is installed. `isogloss list diagnostics` "
       "names all of them.",
       R"(<Severity code="ISO-301" is="note"/>)"},
      {warning, "IG-0242", "{0} wakes while {1} has a value, and no block begins with one: declare its life as modal",
       "A block begins with the modal fields of the block before it and with its words. A field of another life has no "
       "value then, so the syntax is never called for it.",
       "ig::Field<bool> {\"Acme.IsOn\", ig::wake_while}"},
      {error, "IG-0241", "{0} and {1} both answer {2}, and neither says which of them comes first",
       "Two syntaxes that take one code both act on it: a hole is drilled twice, or gets one rapid move too many. "
       "Remove one of them from the chain. Where both must stand, declare the order with after and before, or write "
       "override=\"true\" on the second element.",
       "a vendor's drilling cycle for G81 beside DrillingCycleSyntax"},
      {error, "IG-0243", "{0}: '{1}' is not the path of a code: write Parsing.Flags.{1}",
       "The paths of codes begin with Parsing.Flags. or Parsing.; scanners fill no other fields.", "codes=\"M201\""},
      {warning, "IG-0244", "{0}: the pattern '{2}' of the option {1} matches no field of this chain",
       "Nothing of the option's kind in the chain has such a path, so the pattern is ignored. `isogloss list fields` "
       "prints the paths that exist.",
       R"(lengths="Parsing.G81.?{inch}")"},
      {error, "IG-0240",
       "{0} acts in this block, though nothing that it declares wakes it: its build() must check the block",
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
      {error, "IG-0306", "{0}: the name '{1}' is already used by {2}",
       "Two plugins of one name lie in the folders; the first one found is used.", "two copies of iso.so"},
      {error, "IG-0307", "{0} contributes {1}, which {2} contributes already",
       "The ids of syntaxes and dependencies are unique over all plugins of a dialect.", "two DrillingCycleSyntax"},
      {error, "IG-0308", "{0} could not be created: {1}", "The syntax or dependency refused to start.",
       "an option that the plugin cannot use"},
      {warning, "IG-0309", "{0} exports {1} symbols besides ig_plugin_v1, {2} for instance",
       "Another plugin may bind to a symbol that leaks from this one. Build with isogloss_add_plugin().",
       "a plugin built by hand"},
      {warning, "IG-0310", "{0} declares the diagnostic {1}, which {2} declares already",
       "Codes of diagnostics are unique, so that `isogloss explain CODE` and the severities of a dialect mean one of "
       "them. Each plugin has a prefix of its own.",
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
       "An alarm of the control ends the program there. By default the run goes on with the next block and reports "
       "this note; --on-error stop ends the run.",
       "an impossible arc"},
      {error, "IG-0409", "the table of names is full",
       "A run may make a limited number of names; a program that makes more is not a real one.", "generated text"},
      {error, "IG-0410", "no dependency or column '{0}'", "--set names a value that the dialect does not have.",
       "--set IsoCoordinateTable.G54.Q=1"},
      {error, "IG-0411", "'{1}' is not a valid value for {0}",
       "The value given by --set is not a number within the range.", "--set IsoCoordinateTable.G54.X=ten"},
      {error, "IG-0412", "the block holds the byte 0x{0}, which cannot stand in a program",
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
       "any plugin of the plugin folders.",
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
      {warning, "IG-0423", "the file holds no block: nothing is run", "The file is empty, or holds only blank lines.",
       "an export that was cut off at once"},
      {error, "IG-0430", "{0} is too large to compute with: correct the numbers of this block; the run ends here",
       "A value overflowed, or came so close to it that lengths and angles cannot be computed any more. No position "
       "from there on would mean anything, so the block is not written and no later block runs.",
       "two incremental moves by 1e308"},
      {error, "IG-0431", "the file cannot be read beyond this line ({0}): the run ends, and no output file is kept",
       "The disk or the network failed, or the file became shorter while it was read. The output would be incomplete, "
       "so none is written; an older file of its name stays.",
       "a program on a share that was disconnected"},
      {error, "IG-0432", "{0} has no row '{1}': {2}",
       "No program can reach this row, so it would be ignored silently: correct its name or remove it.",
       "<Offset id=\"g54\" …/>: names of rows are written as the page of the dependency writes them"},
      {error, "IG-0433", "{0} has the row '{1}' already, in line {2}",
       "Only one of two rows with the same name can be used: remove the other.", "a tool that a list names twice"},
      {warning, "IG-0434", "{0} is given values that nothing reads: {1} answers in its place",
       "Both provide the same service, and the first one of the dialect answers. Let the one with the values stand "
       "first, remove the other one, or give the values to the one that answers; `isogloss lint` shows which "
       "dependency answers.",
       "<MachineAxes> with limits behind a parameter table that knows the axes"},
      {warning, "IG-0451", "{0} is called from {1}, a file of another name",
       "No file has the name of the program, but one file in the searched folders holds it. Where several files hold "
       "it, the program is not called.",
       "M98 P1002, where PART2.NC begins with O1002"},
      {error, "IG-0450",
       "stopped after {0} blocks of repeated calls, in pass {3} of {4} of {1} called at {2}: --max-repeat-blocks sets "
       "another limit",
       "So that no output fills the disk, blocks are counted that run again because a call repeats its program. The "
       "first pass of each call is not counted.",
       "a subprogram of a thousand blocks that is called a million times"},
      {error, "IG-0452", "stopped after {0} bytes of output: --max-output sets another limit",
       "So that no program fills the disk. What was written up to there is kept.",
       "a million calls of a long subprogram"},
      {error, "IG-0453", "stopped because the run takes more than {0} MiB of memory: --max-memory sets another limit",
       "A run needs a few megabytes, whatever the size of its program. What was written up to there is kept.",
       "a program that defines texts in an endless loop"},
      {error, "IG-0455", "stopped after {0} motions: --max-motions sets another limit",
       "Blocks and the steps of cycles are counted, so that no program keeps a computer busy for days. What was "
       "written up to there is kept.",
       "a pattern of a million holes, called a thousand times"},
      {error, "IG-0454", "stopped after {0} diagnostics: --max-diagnostics sets another limit",
       "The text is not a program of this control, or a loop reports the same thing a million times. What was written "
       "up to there is kept.",
       "a loop with an unknown code in it"},
      // cases, apply, command line: 0500-0599
      {error, "IG-0501", "malformed page: {0}",
       "A case of a page is a heading, prose, and fences after the lines #Previous:, #Ahead:, #Dependencies:, "
       "#BeforeBuild: and #AfterBuild:; the last two must be there.",
       "#BeforeBuild: without a fence"},
      {error, "IG-0502", "not a JSON object: {0}", "A block document is one JSON object.", R"({"Parsing": {"X": 1,}})"},
      {error, "IG-0503", "the syntax could not run: {0}",
       "The document does not fit the fields of the chain, or the syntax refused to start.",
       R"({"Parsing": {"X": true}})"},
      {error, "IG-0504", "no syntax '{0}'", "`isogloss list syntaxes` names those that are there.",
       "isogloss apply DrilingCycleSyntax"},
      {error, "IG-0505", "case '{0}' of {1} does not hold",
       "One build of the syntax must turn BeforeBuild into AfterBuild "
       "exactly.",
       "a page whose numbers differ from those of its syntax"},
      {error, "IG-0510", "cannot be read: {0}", "The file is missing, is a folder, or may not be read.",
       "isogloss run missing.nc"},
      {error, "IG-0511", "cannot be written: {0}",
       "The folder is missing or write-protected, the disk is full, or the file is neither a regular file, a pipe nor "
       "a character device.",
       "isogloss run part.nc -o /"},
      {error, "IG-0530", "this output would replace {0}, which the run reads: give the output another name",
       "An output file appears under its name when the run is complete. The program, a table or a dialect of the same "
       "run must not be lost to it.",
       "isogloss run part.nc -o part.nc"},
      {error, "IG-0531", "this output and {0} are one file, and one would be lost: give each another name",
       "-o and each --save-table write a file of their own.", "isogloss run part.nc -o x --save-table Table=x"},
      {error, "IG-0640",
       "this file does not begin as a binary motion stream: write one by `isogloss run --format binary`",
       "`isogloss motions` reads what `isogloss run --emit motions --format binary` has written, from its first byte "
       "on.",
       "isogloss motions part.nc"},
      {error, "IG-0641",
       "this motion stream has version {0} and records of {1} bytes: this isogloss reads version {2} with {3} bytes",
       "The stream was written by another version, or its header is damaged. Write it again by the isogloss that reads "
       "it.",
       "isogloss motions written-by-a-later-version.igm"},
      {error, "IG-0642", "the motion stream ends within {0}: it is incomplete, and the events up to there are written",
       "A stream consists of whole records. The run that wrote it, or the copy of the file, was ended in the middle.",
       "head -c 1000 part.igm | isogloss motions -"},
      {error, "IG-0643", "record {0} of the motion stream is damaged: {1}; the events before it are written",
       "Records name texts and circles that came before them, and a kind of event that this isogloss knows. A copy "
       "that "
       "changed bytes, or text that was written into the file, breaks this.",
       "isogloss motions damaged.igm"},
      {error, "IG-0646", "the syntax {0} that a script in Python brings cannot join the chain: {1}",
       "A syntax written in Python names fields and a place in the chain of the dialect. `isogloss inspect DIALECT` "
       "lists "
       "the chain, `isogloss list fields` the fields.",
       "@isogloss.syntax(after=\"FeedRateSyntax\", reads=[\"Parsing.F\"])"},
      {error, "IG-0512", "no dialect in the folders searched",
       "No dialect was named and none could be guessed, since there are none. `isogloss doctor` lists the folders.",
       "isogloss run part.nc --dialects empty"},
      {error, "IG-0513", "{0}",
       "The options of the command line contradict each other, or one has a value that it cannot have.",
       "isogloss run part.nc --emit blocks --format csv"},
      {note, "IG-0514", "dialect {0} ({1}); -d names another",
       "No dialect was named, so it was guessed from the program's text and extension.", "isogloss run part.nc"},
      {error, "IG-0515", "the run has no block at line {0}",
       "The line is empty, lies after the end of the file or of the run, or was jumped over: the hint says which.",
       "isogloss explain part.nc:99999"},
      {warning, "IG-0610",
       "the folder of this command is not known, so only {0} that an option or variable names are found",
       "Plugins and dialects stand beside the command or in its installation. Without /proc the system does not say "
       "where "
       "the command lies: name the folders by --plugins and --dialects, or ISOGLOSS_PLUGIN_PATH and "
       "ISOGLOSS_DIALECT_PATH.",
       "a container without /proc that runs the command by a descriptor"},
      {note, "IG-0611", "nothing takes {0} any longer, as {1} does in {2}: programs that hold them are reported",
       "The edit takes a syntax out of the chain, and no other one takes the codes and words that it takes. Put a "
       "syntax "
       "in its place, or leave the edit out where programs of this control hold them.",
       R"(<Remove syntax="UnitModeSyntax"/>)"},
      {error, "IG-0516", "no syntax, dependency, dialect, field or diagnostic '{0}'",
       "`isogloss list` names what is there.", "isogloss inspect DrilingCycleSyntax"},
      {warning, "IG-0517", "stopped after {0} errors: --max-errors sets another limit",
       "By default 100000: a text with so many is not a program of this control. The run ends after the block that "
       "reports the last of them.",
       "isogloss run part.nc --max-errors 1"},
      {note, "IG-0518", "{0} errors in {1} blocks: this may not be a part program, or it is for another control",
       "At least three of four blocks have an error. `isogloss list dialects` names the dialects, `-d` picks one.",
       "isogloss run README.md"},

      // pictures: 0650-0659
      {warning, "IG-0650", "the picture ends after {0} moves: --max-moves sets another limit",
       "A picture or page keeps each move in memory, by default 20 million of them.",
       "isogloss plot part.nc --max-moves 100"},
      {warning, "IG-0651", "the picture is empty, because the program moves no axis in this dialect",
       "The run has executed the program to its end, and no block of it was a move.", "isogloss plot empty.nc"},
      {error, "IG-0652", "cannot listen on port {0} of this machine ({1}): --port names another, 0 any that is free",
       "The page is served from 127.0.0.1 alone. Another program has the port, or it needs rights.",
       "isogloss view part.nc --serve --port 80"},
      {error, "IG-0653", "pictures are written as SVG only, not as {0}",
       "The file would hold SVG under a name that promises another form, and most programs would refuse to open it.",
       "isogloss plot part.nc -o part.png"},

      // editors: 0660-0669
      {error, "IG-0660", "the program cannot be run: {0}",
       "A syntax or a table could not be created for this program. The server's log has more.", "isogloss lsp"},
      {warning, "IG-0661", "the run was stopped after {0} ms: what follows in the program is not checked",
       "While a program is edited, a run has little time: a loop without an end would stop all answers. The setting "
       "budgetMs gives it more.",
       "isogloss lsp, with a program that jumps back for ever"},
      {note, "IG-0662", "{0} more diagnostics are not listed: the setting maxDiagnostics has another limit",
       "An editor is told the first diagnostics of a program alone, by default 1000.", "isogloss lsp"},
      {error, "IG-0663", "{0} while this program was run: the next change of the text runs it again",
       "A plugin crashed, or ended the process. The server has begun anew and runs this text no second time.",
       "isogloss lsp, with a plugin that crashes"},
  };
  return table;
}

}  // namespace isogloss
