//! The result of a run in one document: why it ended, and what has happened in it (`--summary`, `--result`).

mod document;
mod listed;
mod next_step;
mod recorder;
mod text;

pub(super) use recorder::{ResultRecorder, RunEnd};
