//! Compiled programs as text.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "tests")]

mod assignments;
mod calls;
mod cell;
mod control;
mod counting;
mod data;
mod every_error;
mod execution;
mod expressions;
mod instructions;
mod libraries;
mod library_tasks;
mod linear_loading;
mod lines;
mod media;
mod memory;
mod paths;
mod places;
mod programs;
mod random_programs;
mod rearranged;
mod references;
mod saving;
mod show;
mod snapshots;
mod text_form;
mod unwritable;
