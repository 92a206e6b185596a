//! Reports of states that only a bug of the tools can reach.
//!
//! Bad input gets an error. A look-up that fails only because of a bug calls [`never!`](crate::never!) and continues with a
//! fallback: a build with debug assertions (tests, fuzzing) panics, and a release build passes the message to the hook that
//! the binary has set, because a wrong edit that nobody reports is worse than a crash.

use std::fmt;
use std::ops::Range;
use std::panic::Location;
use std::slice::SliceIndex;
use std::sync::OnceLock;

use rowan::{TextRange, TextSize};

/// Receiver of reports.
pub type BugHook = fn(&Bug<'_>);

static HOOK: OnceLock<BugHook> = OnceLock::new();

/// A state that only a bug can reach.
#[derive(Debug)]
pub struct Bug<'m> {
    /// Location in the source code of the tools.
    pub location: &'static Location<'static>,
    /// Description of the state.
    pub message: fmt::Arguments<'m>,
}

impl fmt::Display for Bug<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "internal error at {}: {}; please report it", self.location, self.message)
    }
}

/// Sets the receiver of reports in release builds. Only the first call of a process has an effect.
pub fn set_bug_hook(hook: BugHook) {
    let _ = HOOK.set(hook);
}

/// Reports a state that only a bug can reach. Called by [`never!`](crate::never!).
#[cold]
#[track_caller]
pub fn report(message: fmt::Arguments<'_>) {
    let bug = Bug { location: Location::caller(), message };
    debug_assert!(false, "{bug}");
    if let Some(hook) = HOOK.get() {
        hook(&bug);
    }
}

/// Reports a state that only a bug can reach: panics with debug assertions, and otherwise calls the hook that the binary
/// has set. The caller continues with a fallback.
#[macro_export]
macro_rules! never {
    ($($message:tt)+) => { $crate::report_bug(format_args!($($message)+)) };
}

/// Parts of texts and slices that exist unless a bug computed the range.
pub trait TextSlice {
    /// Returns this part. A range outside of the text or the slice, or one that divides a character, is reported as a bug,
    /// and the part is empty.
    #[must_use]
    #[track_caller]
    fn part<R: SliceIndex<Self, Output = Self> + fmt::Debug + Clone>(&self, range: R) -> &Self;
}

impl TextSlice for str {
    #[track_caller]
    fn part<R: SliceIndex<Self, Output = Self> + fmt::Debug + Clone>(&self, range: R) -> &Self {
        // No closure, because its location would be reported instead of the caller's.
        let Some(part) = self.get(range.clone()) else {
            never!("{range:?} is no part of a text of {} bytes", self.len());
            return "";
        };
        part
    }
}

impl<T> TextSlice for [T] {
    #[track_caller]
    fn part<R: SliceIndex<Self, Output = Self> + fmt::Debug + Clone>(&self, range: R) -> &Self {
        let Some(part) = self.get(range.clone()) else {
            never!("{range:?} is no part of a list of {} elements", self.len());
            return &[];
        };
        part
    }
}

/// Returns the part of a text in a range of its tree. Any other range is reported as a bug, and the part is empty.
#[must_use]
#[track_caller]
pub fn text_at(text: &str, range: TextRange) -> &str {
    text.part(Range::<usize>::from(range))
}

/// Converts a byte offset in a file. Files have at most 4 GiB: more is reported as a bug, and the offset is 0.
#[must_use]
#[track_caller]
pub fn text_size(offset: usize) -> TextSize {
    let Ok(size) = TextSize::try_from(offset) else {
        never!("offset {offset} in a file of at most 4 GiB");
        return TextSize::default();
    };
    size
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_the_same_as_by_get() {
        assert_eq!("movej(pPick)".part(6..), "pPick)");
        assert_eq!("movej(pPick)".part(..5), "movej");
        assert_eq!("a".part(1..), "");
        assert_eq!([1, 2, 3].as_slice().part(1..2), [2]);
        assert_eq!(text_at("movej", TextRange::new(1.into(), 3.into())), "ov");
        assert_eq!(text_size(7), TextSize::new(7));
    }

    #[test]
    #[should_panic(expected = "5..7 is no part of a text of 4 bytes; please report it")]
    fn a_range_outside_of_a_text_is_a_bug() {
        let _ = "text".part(5..7);
    }

    #[test]
    #[should_panic(expected = "1..2 is no part of a text of 2 bytes")]
    fn a_range_that_divides_a_character_is_a_bug() {
        let _ = "ä".part(1..2);
    }

    #[test]
    fn the_report_names_the_location_of_the_caller() {
        let caught = std::panic::catch_unwind(|| {
            let _ = "text".part(5..7);
        });
        let message = caught.unwrap_err().downcast::<String>().unwrap();
        let line = line!() - 3;
        assert!(message.contains(&format!("never.rs:{line}:")), "{message}");
    }
}
