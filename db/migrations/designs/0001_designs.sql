-- Garment designs. A design is its newest whole snapshot and, after it, everything that was done since, in order.
-- Each checksum is the 64-bit FNV-1a of the other columns of its row, numbers as 8 bytes, little end first.

-- Times in microseconds since 1970, UTC. deleted_us: when it was put into the bin; 0: it was not.
CREATE TABLE design (
    id         INTEGER PRIMARY KEY AUTOINCREMENT,
    name       TEXT    NOT NULL,
    created_us INTEGER NOT NULL,
    changed_us INTEGER NOT NULL,
    deleted_us INTEGER NOT NULL,
    checksum   INTEGER NOT NULL
) STRICT;

-- The design file, as it was after the entry `sequence` of the journal (0: at the start), and the steps that were undone
-- and may be done again, a line each. acts: of the design. The two newest are kept: where one is damaged, the other and
-- the journal give the same.
CREATE TABLE snapshot (
    design_id INTEGER NOT NULL REFERENCES design (id) ON DELETE CASCADE,
    sequence  INTEGER NOT NULL,
    acts      INTEGER NOT NULL,
    design    TEXT    NOT NULL,
    undone    TEXT    NOT NULL,
    checksum  INTEGER NOT NULL,
    PRIMARY KEY (design_id, sequence)
) STRICT;

-- What was done since, numbered without a gap. kind and payload: 0 an act, its steps as the design file writes them, a
-- line each; 1 undone or done again, after how many acts the design stands; 2 the design's new name. version: of the
-- design file.
CREATE TABLE journal (
    design_id INTEGER NOT NULL REFERENCES design (id) ON DELETE CASCADE,
    sequence  INTEGER NOT NULL,
    kind      INTEGER NOT NULL,
    version   INTEGER NOT NULL,
    payload   TEXT    NOT NULL,
    checksum  INTEGER NOT NULL,
    PRIMARY KEY (design_id, sequence)
) STRICT, WITHOUT ROWID;

-- A PNG that any program can show. Apart, because opening a design reads none.
CREATE TABLE design_thumbnail (
    design_id INTEGER PRIMARY KEY REFERENCES design (id) ON DELETE CASCADE,
    png       BLOB    NOT NULL,
    checksum  INTEGER NOT NULL
) STRICT;
