//! Result of a run in one document: the reason of its end, and its events in summary (`--summary`, `--result`).

mod document;
mod listed;
mod next_step;
mod recorder;
mod text;

pub(super) use recorder::{ResultRecorder, RunEnd};
