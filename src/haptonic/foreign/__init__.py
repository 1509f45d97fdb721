"""Files of other programs, read by a process of its own: what a damaged file does to a parser ends there.

`haptonic.foreign.process.ask` sends one question to that process; `child` answers it by a function of
`hdf5`, `matlab` or `tdms`. These import little, because the process starts with every command that reads.
"""
