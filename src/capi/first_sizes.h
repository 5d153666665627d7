// Sizes of structs in the first version of this ABI, written by ./dev freeze. They are those of 64-bit machines. None is kept yet.
