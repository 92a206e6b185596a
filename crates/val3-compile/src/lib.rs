//! From the typed body of a program to its image: the bridge between analysis and run time.
