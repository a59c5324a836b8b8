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
    PRIMARY KEY (model_id, number)
) STRICT;

-- Apart from the views, because a search reads all views and few meshes.
CREATE TABLE display_mesh (
    model_id      INTEGER PRIMARY KEY REFERENCES model (id) ON DELETE CASCADE,
    mesh          BLOB    NOT NULL,
    mesh_checksum INTEGER NOT NULL
) STRICT;
