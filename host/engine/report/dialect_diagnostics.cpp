// The host's own diagnostics: of dialect files, machines and tables, and of restarts in a program.
#include "report/diagnostic_tables.hpp"

namespace isogloss {

std::vector<DiagnosticInfo> dialect_diagnostics() {
  using enum Severity;
  return {
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
       "A file of a <Backup> folder is read by the importer that recognises its text. One that is empty or cut, or is "
       "damaged in more than a quarter of its lines, is not recognised, and all that it holds is missing from the "
       "machine. Get it anew from the control, or name it with its format: <Backup src=\"tool.t\" format=\"…\"/>.",
       "<Backup src=\"backup\"/>, and backup/TOOL.T holds a letter of the maker"},
      {warning, "IG-0143",
       "row '{0}' has {1}={2} here and {1}={4} in line {3} of the file: the later value is taken (such values: {5})",
       "A file of a control gives each value once. One that gives a value twice was edited by hand, or was put "
       "together "
       "from several files: look which of the two is right.",
       "a tool table in which two lines give the length of tool 7"},
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
      {warning, "IG-0184", "{0}: the run reports errors (count: {1}), the first here: {2} [{3}]",
       "`isogloss diff --motions` compares the moves that both runs make. Behind an error, or where a limit has ended "
       "a run, moves may be missing or wrong, also where both sides agree.",
       "isogloss diff --motions old.nc new.nc"},
      {error, "IG-0185", "diff needs two sides: -a and -b, --set-b, --machine-b, --against, or two programs",
       "`isogloss diff` compares two dialects, two machines or two settings with the same programs, or two programs. "
       "Here both sides would be the same.",
       "isogloss diff -d iso part.nc"},
      {error, "IG-0186", "--tolerance needs MM or MM,DEG from 0 to 1000, not '{0}'",
       "With --motions, positions that are not farther apart than this are the same: lengths in mm, angles in degrees. "
       "One number holds for both.",
       "isogloss diff --motions --tolerance -1 old.nc new.nc"},
      {note, "IG-0187", "both sides report the same errors (count: {0}): what follows them may be wrong on both",
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
      {warning, "IG-0623",
       "the spindle speed is not known here: its canonical block has no S, and the S before it stays",
       "After G96 with S in metres per minute, the speed depends on a diameter that the run does not know. A control "
       "that reads the canonical program turns the spindle at the speed of an earlier block.",
       "G97 S1000 M03, then G96 S100 M03"},
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
  };
}

}  // namespace isogloss
