//! The instruction set of the virtual controller: programs as images, with a source map.
