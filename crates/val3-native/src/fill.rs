//! Loops that put one value in the elements of an array, one after the other.
//!
//! Machine code stops at the head of such a loop where many rounds follow. These are done at once in its memory, all but
//! the last, and it is entered again where it was: so the loop goes on as if it had done them.

use std::collections::BTreeMap;

use val3_bytecode::{Image, Op, Program, Register, Step};

use crate::body::Body;
use crate::containers::{Shared, Width};
use crate::exchange::{read, write};
use crate::lanes::Lane;
use crate::layout::{ADDRESS, SIZE};

/// Rounds that follow at least: stopping and being entered again takes as long as some dozens.
const LEAST: i32 = 256;

/// A `for` that stores a value in the element of which its counter is the index, and does nothing else.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fill {
    counter: Register,
    from: Register,
    /// The register of the limit; the step is behind it.
    limit: Register,
    /// Where the array is described.
    array: u32,
    width: Width,
    /// The lines of a round.
    lines: u32,
    /// The step that begins the last of them.
    pub(crate) last_line: u32,
}

/// The loops of a program that fill arrays, by their heads.
pub(crate) fn fills(program: &Program, image: &Image, shared: &Shared) -> BTreeMap<u32, Fill> {
    let of = |(head, round): (u32, &[Step])| Some((head, Fill::of(round, head, (program, image), shared)?));
    (0..).zip(program.code.windows(2)).filter_map(of).collect()
}

impl Fill {
    /// The loop with this head whose rounds consist of these steps.
    fn of(round: &[Step], head: u32, (program, image): (&Program, &Image), shared: &Shared) -> Option<Self> {
        let [Step { op: Op::StoreElement { whole, index, from }, .. }, next] = *round else { return None };
        let Op::ForNextUp { counter, limit, body } = next.op else { return None };
        let lines = round.iter().zip(head..).filter(|(step, _)| step.line);
        let (_, last_line) = lines.clone().last()?;
        (body == head && index == counter && from != counter).then_some(Self {
            counter,
            from,
            limit,
            array: shared.description(whole)?,
            width: Width::declared(whole.kind(), program, image),
            lines: u32::try_from(lines.count()).ok()?,
            last_line,
        })
    }

    /// Does rounds of a loop of the frame whose numbers begin at an address, up to the last but one that there are
    /// elements and lines for. The lines that this takes; `None` where there is no such round.
    pub(crate) fn run(self, bytes: &mut [u8], frame: u32, lines: u32) -> Option<u32> {
        let number = |register: Register| read(bytes, frame + u32::from(register) * 8).map(f64::from_le_bytes);
        let word = |field: u32| read(bytes, self.array + field).map(u32::from_le_bytes);
        let (counter, limit, value) = (number(self.counter)?, number(self.limit)?, number(self.from)?);
        let last = limit.min(f64::from(word(SIZE)?) - 1.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it saturates, and none is 0")]
        let (first, rounds) = (counter as u32, ((last - counter) as u32).min(lines / self.lines));
        if rounds == 0 || counter < 0.0 {
            return None;
        }
        let shift = self.width.shift();
        let begin = (word(ADDRESS)? + (first << shift)) as usize;
        let elements = bytes.get_mut(begin..begin + ((rounds as usize) << shift))?;
        match self.width {
            Width::Byte => elements.fill(u8::from(value != 0.0)),
            Width::Eight => elements.as_chunks_mut().0.fill(value.to_le_bytes()),
        }
        let counter = counter + f64::from(rounds);
        write(bytes, frame + u32::from(self.counter) * 8, &counter.to_le_bytes())?;
        Some(rounds * self.lines)
    }
}

impl Body<'_> {
    /// Stops at the head of a loop that fills an array, if many rounds follow. Where the program was called in machine
    /// code, that would end the machine code of all those that have called it.
    pub(crate) fn stop_at_fill(&mut self, head: u32) {
        let Some(fill) = self.study.fills.get(&head) else { return };
        let Some(entered) = self.entered.filter(|_| self.is_whole(fill.counter)) else { return };
        self.rounds_follow(fill);
        self.code().local_get(entered).i32_and();
        self.is_one(fill.limit + 1);
        self.code().i32_and();
        self.when(|body| body.stop_at(head));
    }

    /// Whether [`LEAST`] rounds follow.
    fn rounds_follow(&mut self, fill: &Fill) {
        if self.is_whole(fill.limit) {
            self.whole(fill.counter);
            self.code().i64_const(LEAST.into()).i64_add();
            self.whole(fill.limit);
            self.code().i64_le_s();
        } else {
            self.get(fill.counter);
            self.code().f64_const(f64::from(LEAST).into()).f64_add();
            self.get(fill.limit);
            self.code().f64_le();
        }
    }

    fn is_one(&mut self, register: Register) {
        match self.study.lanes.get(register) {
            Lane::Constant(value) => _ = self.code().i32_const((value == 1.0).into()),
            _ => {
                self.get(register);
                self.code().f64_const(1.0.into()).f64_eq();
            }
        }
    }
}
