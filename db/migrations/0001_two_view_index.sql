-- Models, each seen from two cameras. A model is whole or absent: its rows are written in one transaction.
-- A *_checksum is the 64-bit FNV-1a of the blob before it; `checksum` covers the plain columns of its row.

-- With which parameters, and by which program, models were described. parameters_hash is the FNV-1a of parameters.
CREATE TABLE build (
    id              INTEGER PRIMARY KEY,
    parameters      TEXT    NOT NULL,
    parameters_hash INTEGER NOT NULL,
    program_version TEXT    NOT NULL,
    UNIQUE (parameters, program_version)
) STRICT;

-- Ids grow in the order of insertion and are never given twice.
CREATE TABLE model (
    id           INTEGER PRIMARY KEY AUTOINCREMENT,
    source_path  TEXT    NOT NULL UNIQUE,
    name         TEXT    NOT NULL,
    class_name   TEXT    NOT NULL,
    content_hash INTEGER NOT NULL,
    file_size    INTEGER NOT NULL,
    build_id     INTEGER NOT NULL REFERENCES build (id),
    checksum     INTEGER NOT NULL
) STRICT;

CREATE INDEX model_of_build ON model (build_id);

-- All that a search reads. An outline without points stands for the samples of the descriptor.
CREATE TABLE view (
    model_id            INTEGER NOT NULL REFERENCES model (id) ON DELETE CASCADE,
    number              INTEGER NOT NULL CHECK (number IN (0, 1)),
    camera_number       INTEGER NOT NULL,
    skeletal_length     REAL    NOT NULL,
    asymmetry           REAL    NOT NULL,
    checksum            INTEGER NOT NULL,
    camera              BLOB    NOT NULL,
    camera_checksum     INTEGER NOT NULL,
    outline             BLOB    NOT NULL,
    outline_checksum    INTEGER NOT NULL,
    descriptor          BLOB    NOT NULL,
    descriptor_checksum INTEGER NOT NULL,
    contour             BLOB    NOT NULL,
    contour_checksum    INTEGER NOT NULL,
    PRIMARY KEY (model_id, number)
) STRICT;

-- A small picture of a model from each view's camera, a PNG that any program can show. Apart from the views, because a
-- search reads none.
CREATE TABLE thumbnail (
    model_id     INTEGER NOT NULL,
    number       INTEGER NOT NULL,
    png          BLOB    NOT NULL,
    png_checksum INTEGER NOT NULL,
    PRIMARY KEY (model_id, number),
    FOREIGN KEY (model_id, number) REFERENCES view (model_id, number) ON DELETE CASCADE
) STRICT;

-- Apart for the same reason.
CREATE TABLE display_mesh (
    model_id      INTEGER PRIMARY KEY REFERENCES model (id) ON DELETE CASCADE,
    mesh          BLOB    NOT NULL,
    mesh_checksum INTEGER NOT NULL
) STRICT;
