//! Lines before which tasks stop, in all images that are or will be in memory.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use val3_bytecode::{Image, LineMark, Program};

/// Lines before which tasks stop.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stops(Arc<LineStops>);

#[derive(Debug, Clone, Default)]
struct LineStops {
    /// Rows by file.
    rows: BTreeMap<String, BTreeSet<u32>>,
    /// Programs before whose first line tasks stop; `false` if they no longer do.
    programs: BTreeMap<String, bool>,
}

impl Stops {
    /// Replaces the rows of a file.
    pub(crate) fn set(&mut self, file: &str, rows: BTreeSet<u32>) {
        Arc::make_mut(&mut self.0).rows.insert(file.to_owned(), rows);
    }

    /// Replaces the programs before whose first line tasks stop.
    pub(crate) fn set_programs(&mut self, names: BTreeSet<String>) {
        let programs = &mut Arc::make_mut(&mut self.0).programs;
        programs.values_mut().for_each(|is_stop| *is_stop = false);
        programs.extend(names.into_iter().map(|name| (name, true)));
    }

    /// Sets the stop marks in the image's programs. The image is copied if a mark changes.
    pub(crate) fn mark(&self, image: &mut Arc<Image>) {
        for number in 0..image.programs.len() {
            let wanted = image.programs.get(number).map(|program| self.marks(image, program)).unwrap_or_default();
            if wanted.is_empty() {
                continue;
            }
            if let Some(program) = Arc::make_mut(image).programs.get_mut(number) {
                for (op, mark) in wanted {
                    if let Some(step) = program.code.get_mut(op) {
                        step.mark = mark;
                    }
                }
            }
        }
    }

    /// Returns the operations of a program whose marks have to change. The head of a `for` and its next iteration
    /// belong to the same line. A line with a stop is no longer counted.
    fn marks(&self, image: &Image, program: &Program) -> Vec<(usize, LineMark)> {
        let rows = image.files.get(program.file as usize).and_then(|file| self.0.rows.get(file));
        let begins_with_stop = self.0.programs.get(&program.name);
        if rows.is_none() && begins_with_stop.is_none() {
            return Vec::new();
        }
        let halts: BTreeSet<u32> =
            rows.into_iter().flatten().filter_map(|row| program.halt_from(*row)).map(|halt| halt.op).collect();
        let marks = (0..).zip(&program.code).filter_map(|(op, step)| {
            let is_entry = begins_with_stop == Some(&true) && program.entry() == Some(op);
            let is_stop = is_entry || program.halt_at(op).is_some_and(|halt| halts.contains(&halt.op));
            let is_closing = program.closings.iter().any(|closing| closing.op == op);
            let mark = match (step.mark.begins_line(), is_stop) {
                (true, true) => LineMark::Stop,
                (true, false) => LineMark::Line,
                (false, true) => LineMark::StopWithin,
                (false, false) => LineMark::Within,
            };
            let is_kept = match step.mark.begins_line() {
                true => !is_stop && step.mark.counter().is_some(),
                false => !is_closing || step.mark.counter().is_some(),
            };
            (!is_kept && step.mark != mark).then_some((op as usize, mark))
        });
        marks.collect()
    }
}
