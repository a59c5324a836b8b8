-- A small picture of a model from each kept view's camera, a PNG that any program can show. Apart from the views, because
-- a search reads none. Models of older programs have none until they are described again.
CREATE TABLE thumbnail (
    model_id     INTEGER NOT NULL,
    number       INTEGER NOT NULL,
    png          BLOB    NOT NULL,
    png_checksum INTEGER NOT NULL,
    PRIMARY KEY (model_id, number),
    FOREIGN KEY (model_id, number) REFERENCES view (model_id, number) ON DELETE CASCADE
) STRICT;
