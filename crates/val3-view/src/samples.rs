//! Samples of the arm in binary batches.

use val3_lang::ports::Time;
use val3_motion::{Sample, SpeedLimit};
use val3_vm::CYCLE;

/// First byte of a batch, which identifies its kind.
const KIND: u8 = 1;

/// Maximum time that a batch covers, in a live run and in a recording. In a recording, long batches take less space.
const LIVE: Time = 10 * CYCLE;
const RECORDED: Time = 250 * CYCLE;

/// Units per degree or mm in a batch, and per mm/s.
const JOINT_UNITS: f64 = 1e6;
const SPEED_UNITS: f64 = 100.0;

/// Order of the differences in columns that change steadily, and in columns of joints. The acceleration of an axis is
/// often constant, so its third differences are nearly zero.
const STEADY: usize = 2;
const ACCELERATED: usize = 3;

/// Source number of a sample that no line has requested.
pub(crate) const NO_SOURCE: u16 = u16::MAX;

/// Properties of a sample that rarely change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SampleOrigin {
    /// Index of the motion phase.
    pub(crate) phase: u8,
    /// Number of the tool.
    pub(crate) tool: u8,
    /// Number of the line that requests the move.
    pub(crate) source: u16,
    /// Number of the speed limit.
    pub(crate) limit: u8,
}

/// Samples in the unfinished batch.
#[derive(Debug)]
pub(crate) struct Batch {
    /// Maximum time that the batch covers.
    length: Time,
    /// Time of the first sample.
    begun: Time,
    times: Vec<i64>,
    /// One column for each axis.
    joints: Vec<Vec<i64>>,
    speeds: Vec<i64>,
    origins: Vec<SampleOrigin>,
}

impl Batch {
    /// Creates an empty batch. Batches of recordings are longer.
    pub(crate) fn new(axes: usize, is_recorded: bool) -> Self {
        Self {
            length: if is_recorded { RECORDED } else { LIVE },
            begun: 0,
            times: Vec::new(),
            joints: vec![Vec::new(); axes],
            speeds: Vec::new(),
            origins: Vec::new(),
        }
    }

    #[cfg(test)]
    pub(crate) fn is_empty(&self) -> bool {
        self.times.is_empty()
    }

    /// Adds a sample at a time.
    pub(crate) fn add(&mut self, time: Time, sample: &Sample, origin: SampleOrigin) {
        if self.times.is_empty() {
            self.begun = time;
        }
        self.times.push(i64::try_from(time).unwrap_or(i64::MAX));
        for (column, joint) in self.joints.iter_mut().zip(sample.joints) {
            column.push(units(joint, JOINT_UNITS));
        }
        self.speeds.push(units(sample.speed.0, SPEED_UNITS));
        self.origins.push(origin);
    }

    /// Whether a sample at this time belongs to the next batch.
    pub(crate) fn is_full(&self, time: Time) -> bool {
        !self.times.is_empty() && time >= self.begun + self.length
    }

    /// Removes and returns the message with all samples; `None` without samples.
    pub(crate) fn take(&mut self) -> Option<Vec<u8>> {
        let count = u32::try_from(self.times.len()).ok().filter(|count| *count > 0)?;
        let mut message = vec![KIND, u8::try_from(self.joints.len()).unwrap_or(u8::MAX), 0, 0];
        message.extend(count.to_le_bytes());
        write_column(&mut message, &mut self.times, STEADY);
        for column in &mut self.joints {
            write_column(&mut message, column, ACCELERATED);
        }
        write_column(&mut message, &mut self.speeds, STEADY);
        write_origins(&mut message, &self.origins);
        self.origins.clear();
        Some(message)
    }
}

/// Converts a number to a whole number of units.
fn units(number: f64, units: f64) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "a cast saturates")]
    let whole = (number * units).round() as i64;
    whole
}

/// Writes the differences of a column up to an order, and clears the column. The first value is written unchanged, the
/// second value as its difference from the first, and so on up to the order.
fn write_column(message: &mut Vec<u8>, column: &mut Vec<i64>, order: usize) {
    // Differences at the previous value, by order; the difference of order 0 is the value.
    let mut previous = [0_i64; ACCELERATED + 1];
    for (index, value) in column.drain(..).enumerate() {
        let mut difference = value;
        for last in previous.iter_mut().take(order.min(index)) {
            let next = difference.wrapping_sub(*last);
            *last = difference;
            difference = next;
        }
        if let Some(last) = previous.get_mut(order.min(index)) {
            *last = difference;
        }
        write_number(message, zigzag(difference));
    }
}

/// Writes each run of equal origins as its length and its origin.
fn write_origins(message: &mut Vec<u8>, origins: &[SampleOrigin]) {
    for run in origins.chunk_by(PartialEq::eq) {
        let Some(SampleOrigin { phase, tool, source, limit }) = run.first() else { continue };
        write_number(message, run.len() as u64);
        message.extend([*phase, *tool, *limit]);
        write_number(message, u64::from(*source));
    }
}

/// Zigzag encoding: maps 0, -1, 1, -2 … to 0, 1, 2, 3 …, so that numbers near zero are small.
fn zigzag(number: i64) -> u64 {
    (number.cast_unsigned() << 1) ^ (number >> 63).cast_unsigned()
}

/// Writes a number in groups of seven bits, lowest first. All bytes except the last have the highest bit set.
fn write_number(message: &mut Vec<u8>, mut number: u64) {
    while number >= 0x80 {
        message.push((number & 0x7f) as u8 | 0x80);
        number >>= 7;
    }
    message.push(number as u8);
}

/// Names of the speed limits, by their numbers in samples.
pub(crate) fn limit_names() -> Vec<String> {
    SpeedLimit::all().map(|limit| limit.to_string()).collect()
}

/// Returns the number of a speed limit.
pub(crate) fn number_of(limit: SpeedLimit) -> u8 {
    SpeedLimit::all().zip(0..).find(|(known, _)| *known == limit).map_or(u8::MAX, |(_, number)| number)
}

#[cfg(test)]
mod tests {
    use val3_motion::{MillimetresPerSecond, MotionPhase};

    use super::*;

    fn sample(first: f64, speed: f64) -> Sample {
        Sample {
            joints: [first, 2.0, 3.0, 4.0, 5.0, 6.0],
            id: 7.5,
            speed: MillimetresPerSecond(speed),
            phase: MotionPhase::Stopping,
            pose: val3_geometry::IsometryMatrix3::identity(),
        }
    }

    const ORIGIN: SampleOrigin = SampleOrigin { phase: 5, tool: 2, source: 300, limit: 1 };

    #[test]
    fn a_batch_has_the_layout_of_the_protocol() {
        let mut batch = Batch::new(2, false);
        assert_eq!(batch.take(), None);
        batch.add(4_000_000, &sample(1e-6, 0.01), ORIGIN);
        batch.add(8_000_000, &sample(3e-6, 0.03), ORIGIN);
        batch.add(12_000_000, &sample(6e-6, 0.05), ORIGIN);
        batch.add(16_000_000, &sample(1e-5, 0.05), SampleOrigin { source: 7, ..ORIGIN });
        assert!(!batch.is_full(40_000_000) && batch.is_full(44_000_000));
        let bytes = batch.take().unwrap();
        assert_eq!(bytes[..8], [1, 2, 0, 0, 4, 0, 0, 0]);
        // 4,000,000 ns, then a difference of the same size.
        assert_eq!(bytes[8..18], [0x80, 0xa4, 0xe8, 3, 0x80, 0xa4, 0xe8, 3, 0, 0]);
        // The units 1, 3, 6 and 10 are written as 1, first difference 2, second difference 1, third difference 0.
        assert_eq!(bytes[18..22], [2, 4, 2, 0]);
        // Two degrees, constant.
        assert_eq!(bytes[22..29], [0x80, 0x92, 0xf4, 1, 0, 0, 0]);
        // Speeds of 1, 3, 5 and 5 units.
        assert_eq!(bytes[29..33], [2, 4, 0, 3]);
        assert_eq!(bytes[33..], [3, 5, 2, 1, 0xac, 2, 1, 5, 2, 1, 7]);
        assert_eq!(batch.take(), None);
        assert!(!batch.is_full(99_000_000));
    }

    #[test]
    fn a_recorded_batch_covers_a_second() {
        let mut batch = Batch::new(6, true);
        batch.add(0, &sample(0.0, 0.0), ORIGIN);
        assert!(!batch.is_full(996_000_000) && batch.is_full(1_000_000_000));
    }

    #[test]
    fn limits_have_names() {
        assert_eq!(limit_names()[usize::from(number_of(SpeedLimit::Translation))], "tvel");
    }
}
