// The host's own diagnostics: of runs, of the command and of editors.
#include "report/diagnostic_tables.hpp"

namespace isogloss {

std::vector<DiagnosticInfo> run_diagnostics() {
  using enum Severity;
  return {
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
       "#BeforeBuild: and #AfterBuild:; the last two must be there. A null in #AfterBuild: says that a value or a "
       "section is gone that was there before the build.",
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
      {warning, "IG-0612", "{0} names {1}, which is no folder: nothing is looked for there",
       "The option has no effect. Look for a misspelt name, or a folder that is not mounted.",
       "isogloss run part.nc --plugins misspelt"},
      {note, "IG-0613", "{0} has no use for {1}: is the number right, and the column?",
       "The table keeps these values, and a program that asks for them gets them, but no syntax acts on them. Where a "
       "number or a column was mistaken, what was meant has its default.",
       R"(<Parameter number="1302" Value="5"/>)"},
      {error, "IG-0516", "no syntax, dependency, dialect, field or diagnostic '{0}'",
       "`isogloss list` names what is there.", "isogloss inspect DrilingCycleSyntax"},
      {warning, "IG-0517", "stopped after {0} errors: --max-errors sets another limit",
       "By default 100000: a text with so many is not a program of this control. The run ends after the block that "
       "reports the last of them.",
       "isogloss run part.nc --max-errors 1"},
      {note, "IG-0518", "{0} errors in {1} blocks: this may not be a part program, or it is for another control",
       "At least three of four blocks have an error. `isogloss list dialects` names the dialects, `-d` picks one.",
       "isogloss run README.md"},
      {warning, "IG-0519", "{0} has no effect: {1}",
       "The output that was chosen, the rest of the command line or the files have no use for the option. Leave it "
       "out, or choose another output.",
       "isogloss run part.nc --emit none --format csv"},
      {note, "IG-0521", "the range goes to line {0}, but the file has {1} lines",
       "A range names its first line and its last one; lines that the file does not have are not explained.",
       "isogloss explain part.nc:10-99999"},

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

      // many programs: 0670-0679
      {error, "IG-0670", "no program was found: {0} files and folders are ignored",
       "In folders a batch ignores links, pipes, devices, names that begin with a dot, results of batches, files that "
       "--include or --exclude rules out, and without --include also files named .xml and files with NUL bytes. A "
       "program that is named itself always runs.",
       "isogloss batch tables -o results"},
      {note, "IG-0671", "{0} files and folders below the named folders are not programs: they are ignored",
       "In folders a batch ignores links, pipes, devices, names that begin with a dot, results of batches, files that "
       "--include or --exclude rules out, and without --include also files named .xml and files with NUL bytes. A "
       "program that is named itself always runs.",
       "isogloss batch archive --exclude '*.txt' -o results"},
      {note, "IG-0672", "{0} lines of the journal cannot be read: their programs run again",
       "A line is cut off where a batch was killed while it wrote. All others count. A file of the journal that cannot "
       "be read counts as one line.",
       "isogloss batch archive -o results"},
      {error, "IG-0673", "{0} of {1} programs have no result yet: no results are written",
       "Some parts of the batch have not run, or not to their end, or what they depend on has changed since then. Run "
       "those parts again, then --merge.",
       "isogloss batch archive -o results --merge"},
      {error, "IG-0674", "the jobs are not submitted ({0}); their scripts are {1} and {2}",
       "sbatch belongs to Slurm. Where it stands on another machine, submit both scripts there.",
       "isogloss batch archive -o results --slurm 8"},
      {error, "IG-0675", "the batch cannot go on: {0}",
       "What is finished is kept in the folder of the results: when the cause is gone, the same command goes on from "
       "there. Where a table, machine, dialect or plugin changes again and again, give "
       "the batch a copy of it.",
       "isogloss batch archive -o results, with no file descriptor left"},
      {note, "IG-0676", "the first line is the path of a file or folder, so this is read as a list of programs",
       "A list has a path in each line, as seen from the folder where the command runs. A file whose first line is a "
       "bare name is a program, for O0001 may be both: --list reads such a list.",
       "isogloss batch list.txt -o results"},
      {warning, "IG-0677", "--changed-since finds no results of a batch in this folder: it takes over none",
       "It takes the folder that an earlier batch had as -o. In a first batch there is none yet.",
       "isogloss batch archive -o results --changed-since misspelt"},

      // untrusted programs and plugins: 0680-0689
      {error, "IG-0680", "--untrusted cannot be kept here, so nothing was run: {0}",
       "--untrusted needs Linux with seccomp filters and listeners for them (5.0), an isogloss that was built with "
       "libseccomp, and no other listener around it.",
       "isogloss run part.nc --untrusted, on an old kernel"},
      {error, "IG-0681", "the work tried what --untrusted forbids, and was ended: {0}",
       "Under --untrusted the work may read its own inputs, calculate and print. It may not open files for writing, "
       "change names or rights, connect, start processes, signal or examine others, or raise its limits. Isogloss "
       "itself "
       "does none of it, so a plugin did: it is hostile, or needs what you do not grant. No output file was written.",
       "isogloss run part.nc --untrusted, with a plugin that opens a socket"},
      {error, "IG-0682", "the work was ended, because {0}: the output ends here, and no file was written",
       "--untrusted ends what takes longer than --max-time, on the clock or on the processor, needs more than "
       "--max-memory, prints more than --max-output, or begins more than 64 threads.",
       "isogloss run part.nc --untrusted --max-time 10"},
      {error, "IG-0683", "the work came to no end of its own: {0}; no output file was written",
       "Under --untrusted a process of its own does the work. It crashed, or a plugin ended it.",
       "isogloss run part.nc --untrusted, with a plugin that ends the process"},
      {note, "IG-0684", "this kernel cannot confine reading: the work can read what you can read",
       "Where the kernel has Landlock (Linux 5.13), --untrusted also confines reading to the folders of the plugins, "
       "dialects, machines and programs and to the system's libraries. All other promises hold without it.",
       "isogloss run part.nc --untrusted, on an old kernel"},
      {error, "IG-0685", "with --untrusted a program is a file, or - for standard input",
       "The work can open nothing but files in their folders. Give what comes from a pipe to standard input.",
       "isogloss run --untrusted <(zcat part.nc.gz)"},
  };
}

}  // namespace isogloss
