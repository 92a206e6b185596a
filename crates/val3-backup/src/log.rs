//! Messages in the logs of a controller.
//!
//! A CS8 writes `errors.log`, a text with one message a line. A CS9 writes `system.log` and `user.log`, with one JSON
//! object a line. Each line that is not blank becomes one [`LogEntry`]; a line in no known form is an entry with
//! [`LineForm::Unknown`], so that no line is lost.

mod application_state;
mod entry;
mod explanation;
mod json_form;
mod lines;
mod log_files;
mod merged;
mod running;
mod source;
mod subject;
mod text_form;

pub use application_state::{ApplicationHistory, ApplicationState, UnknownCause};
pub use entry::{LineForm, LogEntry};
pub use explanation::{EntryExplanation, Topic, explanation};
pub use lines::{entries, foreign_content, line_entry};
pub use log_files::{LogFolder, log_folders};
pub use merged::{LoggedEntry, merged};
pub use running::RunningApplications;
pub use source::{FoundLines, ProgramSources, SourceLine};
pub use subject::Subject;
