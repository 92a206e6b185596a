//! Samples of the arm in binary batches.

use val3_lang::ports::Time;
use val3_machine::event::seconds;
use val3_motion::{Sample, SpeedLimit};
use val3_vm::CYCLE;

/// First byte of a batch.
const KIND: u8 = 1;

/// Maximum time that a batch covers.
const BATCH: Time = 10 * CYCLE;

/// Source number of a sample without a requesting line.
pub(crate) const NO_SOURCE: u16 = u16::MAX;

/// Samples in a batch that is not full.
#[derive(Debug)]
pub(crate) struct Batch {
    axes: usize,
    bytes: Vec<u8>,
    count: u32,
    /// Time of the first sample.
    begun: Time,
}

impl Batch {
    pub(crate) fn new(axes: usize) -> Self {
        Self { axes, bytes: Vec::new(), count: 0, begun: 0 }
    }

    /// Adds a sample at a time, with the limit of the arm's speed, and the numbers of the tool and of the line that
    /// requested the move.
    pub(crate) fn add(&mut self, time: Time, sample: &Sample, limit: SpeedLimit, tool: u8, source: u16) {
        if self.count == 0 {
            self.begun = time;
        }
        self.count += 1;
        let joints = sample.joints.iter().take(self.axes);
        for number in [seconds(time)].iter().chain(joints).chain([&sample.id]) {
            self.bytes.extend(number.to_le_bytes());
        }
        #[expect(clippy::cast_possible_truncation, reason = "a speed for people")]
        let speed = sample.speed.0 as f32;
        self.bytes.extend(speed.to_le_bytes());
        self.bytes.extend([sample.phase as u8, tool]);
        self.bytes.extend(source.to_le_bytes());
        self.bytes.push(number_of(limit));
    }

    /// Whether a sample at this time belongs to the next batch.
    pub(crate) fn is_full(&self, time: Time) -> bool {
        self.count > 0 && time >= self.begun + BATCH
    }

    /// Removes and returns the message with all samples; `None` without samples.
    pub(crate) fn take(&mut self) -> Option<Vec<u8>> {
        let count = std::mem::take(&mut self.count);
        let samples = std::mem::take(&mut self.bytes);
        let mut message = vec![KIND, u8::try_from(self.axes).unwrap_or(u8::MAX), 0, 0];
        message.extend(count.to_le_bytes());
        message.extend(samples);
        (count > 0).then_some(message)
    }
}

/// Names of the speed limits, by their numbers in samples.
pub(crate) fn limit_names() -> Vec<String> {
    SpeedLimit::all().map(|limit| limit.to_string()).collect()
}

fn number_of(limit: SpeedLimit) -> u8 {
    SpeedLimit::all().zip(0..).find(|(known, _)| *known == limit).map_or(u8::MAX, |(_, number)| number)
}

#[cfg(test)]
mod tests {
    use val3_motion::{MillimetresPerSecond, MotionPhase};

    use super::*;

    #[test]
    fn a_batch_has_the_layout_of_the_protocol() {
        let mut batch = Batch::new(4);
        assert_eq!(batch.take(), None);
        let sample = Sample {
            joints: [1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
            id: 7.5,
            speed: MillimetresPerSecond(250.0),
            phase: MotionPhase::Stopping,
            pose: val3_geometry::IsometryMatrix3::identity(),
        };
        batch.add(4_000_000, &sample, SpeedLimit::Translation, 2, 300);
        assert!(!batch.is_full(40_000_000) && batch.is_full(44_000_000));
        let bytes = batch.take().unwrap();
        assert_eq!(bytes[..8], [1, 4, 0, 0, 1, 0, 0, 0]);
        let number = |at: usize| f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap());
        let numbers: Vec<f64> = (0..6).map(|index| number(8 + 8 * index)).collect();
        assert_eq!(numbers, [0.004, 1.0, 2.0, 3.0, 4.0, 7.5]);
        assert_eq!(bytes[56..60], 250.0_f32.to_le_bytes());
        assert_eq!(bytes[60..64], [5, 2, 44, 1]);
        assert_eq!((bytes.len(), limit_names()[usize::from(bytes[64])].as_str()), (65, "tvel"));
        assert_eq!(batch.take(), None);
    }
}
