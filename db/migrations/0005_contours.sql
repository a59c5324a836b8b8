-- The whole-contour reading of each kept view (db/codec/contour_codec.hpp). A model of an older program has none: it is
-- passed over by searches and described again by the next build.
CREATE TABLE contour (
    model_id         INTEGER NOT NULL,
    number           INTEGER NOT NULL,
    contour          BLOB    NOT NULL,
    contour_checksum INTEGER NOT NULL,
    PRIMARY KEY (model_id, number),
    FOREIGN KEY (model_id, number) REFERENCES view (model_id, number) ON DELETE CASCADE
) STRICT;
