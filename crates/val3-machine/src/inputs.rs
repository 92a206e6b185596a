//! Recorder of external input.
//!
//! All calls to lines, media and the library compiler pass through it, in the same order in every execution. While
//! recording is on, it stores each result under its call number. After a snapshot is restored, calls with a recorded
//! result return that result, and only later calls reach the outside. No external read or write is executed twice.

use std::any::Any;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;
use std::rc::Rc;

/// Result of a call to the outside.
pub trait Answer: Clone + 'static {
    /// Heap memory of the result, in bytes.
    fn held_bytes(&self) -> usize {
        0
    }
}

impl Answer for () {}
impl Answer for bool {}

impl Answer for Vec<String> {
    fn held_bytes(&self) -> usize {
        self.iter().map(|text| size_of::<String>() + text.len()).sum()
    }
}

impl<T: Answer, E: Clone + 'static> Answer for Result<T, E> {
    fn held_bytes(&self) -> usize {
        self.as_ref().map_or(0, T::held_bytes)
    }
}

/// Recorder of external input. Clones share one recording.
#[derive(Clone, Default)]
pub struct Inputs(Rc<RefCell<InputRecording>>);

#[derive(Default)]
struct InputRecording {
    is_on: bool,
    /// Number of the next call.
    next: u64,
    /// Number of recorded calls.
    recorded: u64,
    /// Results by call number. Usual results are omitted.
    answers: BTreeMap<u64, Recorded>,
    /// Estimated size of the results, in bytes.
    bytes: u64,
}

struct Recorded {
    answer: Rc<dyn Any>,
    bytes: u64,
}

impl Recorded {
    fn new<T: Answer>(answer: T) -> Self {
        let bytes = size_of::<(u64, Self)>() + size_of::<T>() + answer.held_bytes();
        Self { answer: Rc::new(answer), bytes: bytes as u64 }
    }
}

impl Inputs {
    /// Starts the recording unless it is on, and returns the number of the next call.
    pub fn mark(&self) -> u64 {
        let mut recording = self.0.borrow_mut();
        recording.is_on = true;
        recording.next
    }

    /// Returns to a mark: the next calls return the results that were recorded after it.
    pub fn rewind(&self, mark: u64) {
        let mut recording = self.0.borrow_mut();
        recording.next = mark.min(recording.recorded);
    }

    /// Discards the results before a mark. No return to an earlier mark is possible afterwards.
    pub fn forget_before(&self, mark: u64) {
        let mut recording = self.0.borrow_mut();
        let kept = recording.answers.split_off(&mark);
        let forgotten = std::mem::replace(&mut recording.answers, kept);
        recording.bytes -= bytes(&forgotten);
    }

    /// Returns to a mark and discards the results after it, so that the next calls reach the outside again.
    pub(crate) fn rewind_anew(&self, mark: u64) {
        let mut recording = self.0.borrow_mut();
        let forgotten = recording.answers.split_off(&mark);
        recording.bytes -= bytes(&forgotten);
        (recording.next, recording.recorded) = (mark, mark);
    }

    /// Estimated size of the recorded results, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.0.borrow().bytes
    }

    /// Ends the recording and discards its results, so that all calls reach the outside.
    pub fn end(&self) {
        let mut recording = self.0.borrow_mut();
        *recording = InputRecording { next: recording.next, recorded: recording.next, ..InputRecording::default() };
    }

    /// Returns the recorded result of the call, or executes it.
    pub fn ask<T: Answer>(&self, question: impl FnOnce() -> T) -> T {
        self.answer(|recorded| recorded, question, |_| false)
    }

    /// Like [`ask`](Self::ask). `usual` is the frequent result, which is not stored.
    pub fn ask_usual<T: Answer + PartialEq>(&self, usual: &T, question: impl FnOnce() -> T) -> T {
        self.answer(|recorded| recorded.or_else(|| Some(usual.clone())), question, |answer| answer == usual)
    }

    fn answer<T: Answer>(
        &self,
        recorded: impl FnOnce(Option<T>) -> Option<T>,
        question: impl FnOnce() -> T,
        is_usual: impl FnOnce(&T) -> bool,
    ) -> T {
        if let Some(answer) = self.0.borrow_mut().replay(recorded) {
            return answer;
        }
        let answer = question();
        self.0.borrow_mut().record(|| (!is_usual(&answer)).then(|| Recorded::new(answer.clone())));
        answer
    }
}

impl InputRecording {
    /// Returns the recorded result of the next call; `None` at the end of the recording.
    ///
    /// An execution with another call than the recorded call has left the recording, whose rest is dropped.
    fn replay<T: Clone + 'static>(&mut self, recorded: impl FnOnce(Option<T>) -> Option<T>) -> Option<T> {
        if self.next >= self.recorded {
            return None;
        }
        let stored = self.answers.get(&self.next);
        let answer = stored.and_then(|stored| stored.answer.downcast_ref::<T>()).cloned();
        let is_other = stored.is_some() && answer.is_none();
        match recorded(answer).filter(|_| !is_other) {
            Some(answer) => {
                self.next += 1;
                Some(answer)
            }
            None => {
                self.recorded = self.next;
                let dropped = self.answers.split_off(&self.next);
                self.bytes -= bytes(&dropped);
                None
            }
        }
    }

    fn record(&mut self, answer: impl FnOnce() -> Option<Recorded>) {
        if self.is_on {
            if let Some(answer) = answer() {
                self.bytes += answer.bytes;
                self.answers.insert(self.next, answer);
            }
            self.next += 1;
            self.recorded = self.next;
        }
    }
}

fn bytes(answers: &BTreeMap<u64, Recorded>) -> u64 {
    answers.values().map(|stored| stored.bytes).sum()
}

impl fmt::Debug for Inputs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let InputRecording { is_on, next, recorded, .. } = &*self.0.borrow();
        f.debug_struct("Inputs").field("is_on", is_on).field("next", next).field("recorded", recorded).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::{Answer, Inputs};

    impl Answer for i32 {}

    impl Answer for &'static str {
        fn held_bytes(&self) -> usize {
            self.len()
        }
    }

    #[test]
    fn recorded_answers_are_given_again() {
        let inputs = Inputs::default();
        inputs.ask(|| "not recorded");
        let mark = inputs.mark();
        assert_eq!((inputs.ask(|| 1), inputs.ask_usual(&0, || 0), inputs.ask_usual(&0, || 2)), (1, 0, 2));
        inputs.rewind(mark);
        let live = || 9;
        assert_eq!((inputs.ask(live), inputs.ask_usual(&0, live), inputs.ask_usual(&0, live)), (1, 0, 2));
        assert_eq!(inputs.ask(live), 9, "the recording is used up");
    }

    #[test]
    fn an_execution_that_asks_something_else_leaves_the_recording() {
        let inputs = Inputs::default();
        let mark = inputs.mark();
        (0..3).for_each(|number| _ = inputs.ask(|| number));
        inputs.rewind(mark);
        assert_eq!((inputs.ask(|| 7), inputs.ask(|| "live"), inputs.ask(|| 8)), (0, "live", 8));
    }

    #[test]
    fn after_the_end_of_the_recording_the_outside_answers() {
        let inputs = Inputs::default();
        let mark = inputs.mark();
        inputs.ask(|| 1);
        inputs.rewind(mark);
        inputs.end();
        assert_eq!((inputs.ask(|| 2), inputs.ask_usual(&0, || 3)), (2, 3));
        let later = inputs.mark();
        inputs.ask(|| 4);
        inputs.rewind(later);
        assert_eq!(inputs.ask(|| 5), 4, "another recording can begin");
    }

    #[test]
    fn answers_before_a_mark_can_be_forgotten() {
        let inputs = Inputs::default();
        inputs.mark();
        inputs.ask(|| 1);
        let mark = inputs.mark();
        inputs.ask(|| 2);
        inputs.forget_before(mark);
        inputs.rewind(mark);
        assert_eq!(inputs.ask(|| 3), 2);
    }

    #[test]
    fn recorded_bytes_are_counted_until_they_are_forgotten() {
        let inputs = Inputs::default();
        inputs.ask(|| "not recorded");
        let mut marks = Vec::new();
        let mut bytes = vec![inputs.bytes()];
        for text in ["a", "abc", "usual", "abcde"] {
            marks.push(inputs.mark());
            inputs.ask_usual(&"usual", || text);
            bytes.push(inputs.bytes());
        }
        let one = bytes[1] - 1;
        assert!(one > 0);
        assert_eq!(bytes, [0, one + 1, 2 * one + 4, 2 * one + 4, 3 * one + 9]);
        inputs.forget_before(marks[1]);
        assert_eq!(inputs.bytes(), 2 * one + 8);
        // A different call ends the replay.
        inputs.rewind(marks[3]);
        inputs.ask(|| 1);
        assert!(inputs.bytes() < 2 * one + 8);
        inputs.end();
        assert_eq!(inputs.bytes(), 0);
    }
}
