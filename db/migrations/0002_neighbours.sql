-- Which models are near to which, for re-ranking; in indexes alone that were asked to have it, which is what a row of
-- `likeness` says. It names the distance that was measured: lists of another one are worth nothing.
CREATE TABLE likeness (
    id           INTEGER PRIMARY KEY CHECK (id = 1),
    measure      TEXT    NOT NULL,
    measure_hash INTEGER NOT NULL
) STRICT;

-- The nearest others of a model, nearest first. A list is as long as the collection allows and right among all models
-- that have such a list; one that a model was taken out of is short, and measured again. checksum covers the row.
CREATE TABLE neighbour (
    model_id INTEGER NOT NULL REFERENCES model (id) ON DELETE CASCADE,
    place    INTEGER NOT NULL,
    other_id INTEGER NOT NULL REFERENCES model (id) ON DELETE CASCADE,
    distance REAL    NOT NULL,
    checksum INTEGER NOT NULL,
    PRIMARY KEY (model_id, place)
) STRICT, WITHOUT ROWID;

CREATE INDEX neighbour_of_other ON neighbour (other_id);
