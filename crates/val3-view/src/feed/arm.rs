//! Samples of the arm, with the tools and the lines of programs to which they refer.

use val3_geometry::{IsometryMatrix3, Trsf};
use val3_lang::ports::Time;
use val3_machine::controller::{CodeSource, Controller};
use val3_motion::{MotionPhase, Sample, SpeedLimit};
use val3_vm::CYCLE;

use super::{Feed, ViewerMessage};
use crate::samples::{self, NO_SOURCE, SampleOrigin};
use crate::wire::{self, Source, Tool};
use crate::{numbers, positions};

/// Tolerance within which two tools are equal, in mm and degrees.
const SAME_TOOL: f64 = 1e-6;

/// Tool number that all tools after the first 255 share.
const OTHER_TOOL: u8 = u8::MAX;

impl Feed {
    /// Before other messages, sends the pending samples of a live run. In a recording, samples wait for a full batch.
    pub(super) fn release_samples(&mut self) {
        if !self.is_recorded {
            self.flush_samples();
        }
    }

    pub(super) fn flush_samples(&mut self) {
        self.messages.extend(self.batch.take().map(ViewerMessage::Samples));
    }

    /// Adds a sample of the arm, unless the arm is stopped and has not moved.
    pub(super) fn sample(&mut self, time: Time, controller: &Controller) {
        if self.last.is_some_and(|(last, ..)| time < last + CYCLE) {
            return;
        }
        let arm = controller.arm();
        let (sample, limit) = (*arm.sample(), arm.speed_limit());
        let is_new = self.last.is_none_or(|(_, (last, _), _)| last.joints != sample.joints || last.pose != sample.pose);
        if is_new {
            if let Some((resting, (before, before_limit), false)) = self.last {
                self.add(resting, &before, before_limit, controller);
            }
            self.add(time, &sample, limit, controller);
        }
        let ends_motion =
            !is_new && self.last.is_some_and(|(_, (last, _), is_known)| is_known && last.phase != sample.phase);
        if ends_motion {
            self.add(time, &sample, limit, controller);
        }
        self.last = Some((time, (sample, limit), is_new || ends_motion));
    }

    fn add(&mut self, time: Time, sample: &Sample, limit: SpeedLimit, controller: &Controller) {
        if self.batch.is_full(time) {
            self.flush_samples();
        }
        let origin = self.origin(sample, limit, controller);
        self.batch.add(time, sample, origin);
    }

    /// Returns the origin of a sample. Its tool and its line are sent to the pages if they are new.
    pub(super) fn origin(&mut self, sample: &Sample, limit: SpeedLimit, controller: &Controller) -> SampleOrigin {
        let tool = controller.arm().model().flange(&sample.joints).inverse() * sample.pose;
        let tool = self.tool(&tool, controller);
        let source = match sample.phase {
            MotionPhase::Waiting => NO_SOURCE,
            _ => {
                let piece = controller.motion_status().piece;
                self.number_of(piece.and_then(|piece| piece.source).as_ref())
            }
        };
        SampleOrigin { phase: sample.phase as u8, tool, source, limit: samples::number_of(limit) }
    }

    /// Number of a tool. A new tool is sent to the pages.
    pub(super) fn tool(&mut self, tool: &IsometryMatrix3<f64>, controller: &Controller) -> u8 {
        let pose = numbers(&Trsf::from(*tool));
        if let Some(number) = self.tools.iter().position(|known| is_same(known, &pose)) {
            return u8::try_from(number).unwrap_or(OTHER_TOOL);
        }
        let number = u8::try_from(self.tools.len()).unwrap_or(OTHER_TOOL);
        if number != OTHER_TOOL {
            self.tools.push(pose);
            let name = positions::tool_at(controller, |known| is_same(known, &pose));
            self.tell(&wire::Message::Tool(Tool { index: number, name, pose }));
        }
        number
    }

    /// Number of a program line that requests moves. A new line is sent to the pages.
    pub(super) fn number_of(&mut self, source: Option<&CodeSource>) -> u16 {
        let Some(source) = source else { return NO_SOURCE };
        let key = (source.file.clone(), source.line, source.program.clone());
        if let Some(number) = self.sources.get(&key) {
            return *number;
        }
        let Some(number) = u16::try_from(self.sources.len()).ok().filter(|number| *number < NO_SOURCE) else {
            return NO_SOURCE;
        };
        self.sources.insert(key, number);
        self.tell(&wire::Message::Source(Source {
            index: number,
            instruction: source.instruction.to_owned(),
            program: source.program.clone(),
            line: source.line,
            file: source.file.clone(),
        }));
        number
    }
}

fn is_same(known: &[f64; 6], tool: &[f64; 6]) -> bool {
    known.iter().zip(tool).all(|(known, number)| (known - number).abs() < SAME_TOOL)
}
