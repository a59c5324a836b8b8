-- Further segmentations of a view's outline (core/parts/readings.hpp): reading 0 is the view's own descriptor.
CREATE TABLE reading (
    model_id            INTEGER NOT NULL,
    number              INTEGER NOT NULL,
    reading             INTEGER NOT NULL CHECK (reading >= 1),
    descriptor          BLOB    NOT NULL,
    descriptor_checksum INTEGER NOT NULL,
    PRIMARY KEY (model_id, number, reading),
    FOREIGN KEY (model_id, number) REFERENCES view (model_id, number) ON DELETE CASCADE
) STRICT;
