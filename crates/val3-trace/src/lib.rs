//! Recorded motion: traces of runs, their comparison, and limits of the tool centre point.
//!
//! A [`Trace`] is a table of the arm every 4 ms while it moves. [`compare`] compares a recorded trace with the present
//! trace: the distance between the paths, independent of speed, and the times. Limits are conditions of only the
//! present trace. Distances refer to the tool centre point; the links and the body of the tool are ignored.

mod align;
mod comparison;
mod distance;
mod limits;
mod observer;
mod read;
mod recording;
mod report;
mod row;
mod selection;
mod settings;
mod stretch;
#[cfg(test)]
mod testing;
mod thinning;
mod times;
mod write;
mod zone;

pub use comparison::{Comparison, Deviation, MoveComparison, TraceSide, compare};
pub use distance::{Distance, Tolerances};
pub use limits::{Limit, Violation};
pub use observer::PictureObserver;
pub use read::TraceError;
pub use recording::{MotionRecorder, MotionRecording};
pub use report::{Finding, amount, describe, describe_violation};
pub use row::{Trace, TraceRow};
pub use selection::RowSelection;
pub use settings::{Clear, Inside, Positive, Speed, TraceFile, ZoneSetting};
pub use times::{TraceTimes, change};
pub use write::{Precision, head, head_with_limit, is_recording};
pub use zone::Zone;
