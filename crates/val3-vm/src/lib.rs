//! Runs images: tasks, frames of programs, data, scheduling.
