/* isogloss_scan.h - scanners that are asked ahead of the turn of their block; since 1.8.
 *
 * Where a processor is free, the host scans lines ahead of the run. Another instance of the syntax, in another thread,
 * scans lines that may never be executed, and what it finds is given to the block in its turn. conventions.md says what
 * is noted and compared ("Scanning ahead").
 */
#ifndef ISOGLOSS_SCAN_H
#define ISOGLOSS_SCAN_H

#include "isogloss.h"

/* ig_syntax.scan_flags: scan() may be asked ahead. But for values that it gets by ig_host, the text of the block alone
 * decides what it finds; and before it does anything else than to call the host, or keeps something for build(), it
 * calls ig_host.in_turn. A scanner without the flag is asked in its turn only.
 *
 * in_turn: 1, or 0 where the block is scanned ahead. What was found in it is then forgotten, and scan() returns the
 * position at once: the text is scanned again in its turn. */
#define IG_SCANS_AHEAD 1u

#endif
